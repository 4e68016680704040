// Edges of the cells of one level: one instance an edge.

struct Edge {
    @builtin(position) position: vec4<f32>,
    @location(0) along_across_length: vec3<f32>,
    @location(1) strength: f32,
}

@vertex
fn edge_vertex(@builtin(vertex_index) index: u32, @location(0) packed: vec2<u32>) -> Edge {
    let code = decode(packed);
    let axis = u32(draw.shape.z);
    var step = vec3<u32>(0u);
    step[axis] = u32(draw.shape.x);
    var from_offset = offset_from_code(code);
    var to_offset = offset_from_code(code + step);
    // The part behind the slice is left.
    let from_before = before_slice(from_offset);
    let to_before = before_slice(to_offset);
    if from_before > 0.0 && to_before > 0.0 {
        return Edge(vec4<f32>(2.0, 2.0, 2.0, 1.0), vec3<f32>(0.0), 0.0);
    }
    if from_before > 0.0 {
        from_offset = mix(from_offset, to_offset, from_before / (from_before - to_before));
    } else if to_before > 0.0 {
        to_offset = mix(to_offset, from_offset, to_before / (to_before - from_before));
    }
    let s = stroke(from_offset, to_offset, draw.shape.y, index);
    // Edges of a few pixels would only make a grey haze.
    let small = clamp((s.length - 1.0) / 5.0, 0.0, 1.0);
    let corner = square_corner(index);
    let strength = strength_at(mix(from_offset, to_offset, corner.x)) * small;
    return Edge(s.position, vec3<f32>(s.along, s.across, s.length), strength);
}

@fragment
fn edge_fragment(in: Edge) -> @location(0) vec4<f32> {
    let c = in.along_across_length;
    return draw.edge * (coverage(c.x, c.y, c.z, draw.shape.y) * in.strength);
}
