//! The typefaces, as files.

/// Inter, regular.
pub const SANS: &[u8] = include_bytes!("../../../assets/fonts/Inter-Regular.ttf");
/// Inter, semi-bold.
pub const SANS_STRONG: &[u8] = include_bytes!("../../../assets/fonts/Inter-SemiBold.ttf");
/// JetBrains Mono, regular.
pub const MONO: &[u8] = include_bytes!("../../../assets/fonts/JetBrainsMono-Regular.ttf");
/// JetBrains Mono, bold.
pub const MONO_STRONG: &[u8] = include_bytes!("../../../assets/fonts/JetBrainsMono-Bold.ttf");

/// All of them.
pub const ALL: [&[u8]; 4] = [SANS, SANS_STRONG, MONO, MONO_STRONG];
