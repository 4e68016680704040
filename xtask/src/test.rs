//! `cargo xtask test`.

use crate::cargo::{cargo, succeed};
use crate::install::install;
use crate::package::Purpose;

/// Runs all tests of the workspace, pictures on the software renderer;
/// `arguments` go to `cargo test`. Where `CI` is set, they fail without an adapter.
///
/// # Errors
/// Says what is missing or has failed.
pub fn test(arguments: Vec<String>) -> Result<(), String> {
    install(Purpose::Test)?;
    let mut tests = cargo();
    tests.args(["test", "--workspace"]).args(arguments);
    // Other backends draw lines a little differently from the stored pictures.
    if std::env::var_os("WGPU_BACKEND").is_none() {
        tests.env("WGPU_BACKEND", "vulkan");
    }
    succeed(&mut tests)
}
