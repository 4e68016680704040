// What every draw call knows; prepended to the other shaders. Positions are offsets
// from a point near the middle of the picture, in world units.

struct Draw {
    clip_from_offset: mat4x4<f32>,
    /// Homogeneous position of the eye; w = 0 for a parallel projection.
    eye: vec4<f32>,
    /// dot(fade, (offset, 1)) is 0 at the near end of the scene, 1 at the far end.
    fade: vec4<f32>,
    /// Width and height in pixels, pixels per point, strength of the fading.
    viewport: vec4<f32>,
    /// Of cells in space: offset of the reference code, and smallest cell in world
    /// units; of content: offset of its origin. In the plane: position of the reference
    /// code in pixels (x, y), unused, pixels per cell.
    grid: vec4<f32>,
    /// Premultiplied, gamma-encoded colours, as everywhere in the interface.
    fill: vec4<f32>,
    edge: vec4<f32>,
    /// Side of the cell in smallest cells, line width or radius in pixels,
    /// axis of an edge, unused.
    shape: vec4<f32>,
    /// A code near the middle of the picture.
    reference: vec4<i32>,
    /// What is sliced off is where dot(slice, (offset, 1)) is above 0; all 0: nothing.
    slice: vec4<f32>,
}

@group(0) @binding(0) var<uniform> draw: Draw;

/// The three 21-bit numbers of a location code.
fn decode(packed: vec2<u32>) -> vec3<u32> {
    return vec3<u32>(
        packed.x & 0x1fffffu,
        (packed.x >> 21u) | ((packed.y & 0x3ffu) << 11u),
        (packed.y >> 10u) & 0x1fffffu,
    );
}

/// How far a point lies before the plane of the slice; above 0 it is sliced off.
fn before_slice(point: vec3<f32>) -> f32 {
    return dot(draw.slice, vec4<f32>(point, 1.0));
}

/// Exact differences of integers first, so that nothing trembles at any zoom.
fn offset_from_code(code: vec3<u32>) -> vec3<f32> {
    let step = vec3<f32>(vec3<i32>(code) - draw.reference.xyz);
    return draw.grid.xyz + step * draw.grid.w;
}

/// Direction from a point to the eye, of unit length.
fn towards_eye(point: vec3<f32>) -> vec3<f32> {
    return normalize(draw.eye.xyz - point * draw.eye.w);
}

/// How much of a line's colour is left at this depth of the scene.
fn strength_at(point: vec3<f32>) -> f32 {
    let depth = clamp(dot(draw.fade, vec4<f32>(point, 1.0)), 0.0, 1.0);
    return 1.0 - draw.viewport.w * depth;
}

/// Corner 0..6 of the two triangles of a unit square.
fn square_corner(index: u32) -> vec2<f32> {
    let i = select(index - 2u, index, index < 3u); // 0 1 2, then 1 2 3
    return vec2<f32>(f32(i & 1u), f32(i >> 1u));
}

/// Brightness of a surface with this unit normal, lit from beside the eye.
fn lit(normal: vec3<f32>, point: vec3<f32>) -> f32 {
    let eye = towards_eye(point);
    let facing = select(-normal, normal, dot(normal, eye) >= 0.0);
    let light = normalize(eye + vec3<f32>(0.35, 0.25, 0.85));
    return 0.55 + 0.45 * max(dot(facing, light), 0.0);
}

/// A line as a rectangle of pixels, a little larger for soft borders.
struct Stroke {
    position: vec4<f32>,
    /// Pixels along the line from its first end and across it from its middle.
    along: f32,
    across: f32,
    length: f32,
}

fn stroke(from_offset: vec3<f32>, to_offset: vec3<f32>, width: f32, index: u32) -> Stroke {
    var from_clip = draw.clip_from_offset * vec4<f32>(from_offset, 1.0);
    var to_clip = draw.clip_from_offset * vec4<f32>(to_offset, 1.0);
    // Cut off what lies in front of the near plane.
    if from_clip.z < 0.0 && to_clip.z < 0.0 {
        return Stroke(vec4<f32>(2.0, 2.0, 2.0, 1.0), 0.0, 0.0, 0.0);
    }
    if from_clip.z < 0.0 {
        from_clip = mix(from_clip, to_clip, from_clip.z / (from_clip.z - to_clip.z));
    } else if to_clip.z < 0.0 {
        to_clip = mix(to_clip, from_clip, to_clip.z / (to_clip.z - from_clip.z));
    }
    let half_size = draw.viewport.xy * 0.5;
    let a = from_clip.xyz / from_clip.w;
    let b = to_clip.xyz / to_clip.w;
    let step = (b.xy - a.xy) * half_size;
    let length_px = length(step);
    let direction = select(vec2<f32>(1.0, 0.0), step / max(length_px, 1e-6), length_px > 1e-6);
    let corner = square_corner(index);
    let reach = 0.5 * width + 1.0;
    let along = mix(-reach, length_px + reach, corner.x);
    let across = mix(-reach, reach, corner.y);
    let offset = direction * along + vec2<f32>(-direction.y, direction.x) * across;
    let depth = mix(a.z, b.z, corner.x);
    // A hair nearer than the faces that share this edge.
    let nearer = depth - 0.002 * (1.0 - depth) - 1e-6;
    return Stroke(
        vec4<f32>(a.xy + offset / half_size, max(nearer, 0.0), 1.0),
        along, across, length_px,
    );
}

/// Share of a pixel that a line of this width covers.
fn coverage(along: f32, across: f32, length: f32, width: f32) -> f32 {
    let reach = 0.5 * width;
    let sideways = clamp(reach + 0.5 - abs(across), 0.0, min(width, 1.0));
    let beyond = max(-along, along - length);
    return sideways * clamp(reach + 0.5 - beyond, 0.0, 1.0);
}
