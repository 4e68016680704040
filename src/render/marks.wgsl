// Faces and edges of marked boxes, sorted far first: one instance each.

struct Item {
    /// Two opposite corners of a face, or the ends of an edge.
    @location(0) a: vec3<f32>,
    @location(1) b: vec3<f32>,
    @location(2) colour: vec4<f32>,
    /// 0, 1, 2: a face across this axis; 3: an edge.
    @location(3) kind: u32,
    /// Width, length of a dash, and of a dash with its gap, in pixels; no dash: the edge
    /// is solid.
    @location(4) pen: vec3<f32>,
}

struct Mark {
    @builtin(position) position: vec4<f32>,
    @location(0) colour: vec4<f32>,
    @location(1) along_across_length: vec3<f32>,
    /// Width of an edge, below 0 for a face; length of a dash, and with its gap.
    @location(2) pen: vec3<f32>,
}

@vertex
fn mark_vertex(@builtin(vertex_index) index: u32, item: Item) -> Mark {
    if item.kind == 3u {
        let s = stroke(item.a, item.b, item.pen.x, index);
        return Mark(s.position, item.colour, vec3<f32>(s.along, s.across, s.length), item.pen);
    }
    let corner = square_corner(index);
    var offset = item.a;
    let u = (item.kind + 1u) % 3u;
    let v = (item.kind + 2u) % 3u;
    offset[u] = mix(item.a[u], item.b[u], corner.x);
    offset[v] = mix(item.a[v], item.b[v], corner.y);
    let position = draw.clip_from_offset * vec4<f32>(offset, 1.0);
    return Mark(position, item.colour, vec3<f32>(0.0), vec3<f32>(-1.0, 0.0, 0.0));
}

@fragment
fn mark_fragment(in: Mark) -> @location(0) vec4<f32> {
    if in.pen.x < 0.0 {
        return in.colour;
    }
    let c = in.along_across_length;
    var alpha = coverage(c.x, c.y, c.z, in.pen.x);
    // Whole dashes, with half of one at either end; where there is no room for that the
    // edge is solid.
    if in.pen.y > 0.0 && c.z >= 0.75 * in.pen.z {
        let period = c.z / max(round(c.z / in.pen.z), 1.0);
        let dash = period * in.pen.y / in.pen.z;
        let from_middle = abs(c.x - period * round(c.x / period));
        alpha *= clamp(0.5 + 0.5 * dash - from_middle, 0.0, 1.0);
    }
    return in.colour * alpha;
}
