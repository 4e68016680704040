// The three visible faces of the cells of one level: one instance a cell.

struct Face {
    @builtin(position) position: vec4<f32>,
    @location(0) brightness: f32,
    @location(1) before_slice: f32,
}

@vertex
fn face_vertex(@builtin(vertex_index) index: u32, @location(0) packed: vec2<u32>) -> Face {
    let low = offset_from_code(decode(packed));
    let side = draw.shape.x * draw.grid.w;
    let axis = index / 6u;
    let corner = square_corner(index % 6u);

    // Of the two faces across an axis the eye sees the one on its side.
    let centre = low + 0.5 * side;
    let to_eye = draw.eye.xyz - centre * draw.eye.w;
    var point = vec3<f32>(0.0);
    point[axis] = select(0.0, 1.0, to_eye[axis] > 0.0);
    point[(axis + 1u) % 3u] = corner.x;
    point[(axis + 2u) % 3u] = corner.y;

    // A level's own inset keeps faces of different levels apart.
    let inset = draw.shape.w;
    let offset = low + side * mix(vec3<f32>(inset), vec3<f32>(1.0 - inset), point);
    let shades = vec3<f32>(0.86, 0.93, 1.0);
    let brightness = select(shades[axis], 1.0, draw.fill.a < 0.999);
    return Face(draw.clip_from_offset * vec4<f32>(offset, 1.0), brightness, before_slice(offset));
}

@fragment
fn face_fragment(in: Face) -> @location(0) vec4<f32> {
    if in.before_slice > 0.0 {
        discard;
    }
    return vec4<f32>(draw.fill.rgb * in.brightness, draw.fill.a);
}
