// What the tree is built over: points, triangles and spheres.

struct Sprite {
    @builtin(position) position: vec4<f32>,
    @location(0) offset: vec2<f32>,
    @location(1) brightness: f32,
}

@vertex
fn point_vertex(@builtin(vertex_index) index: u32, @location(0) point: vec3<f32>) -> Sprite {
    let at = draw.grid.xyz + point;
    let offset = square_corner(index) * 2.0 - 1.0;
    if before_slice(at) > 0.0 {
        return Sprite(vec4<f32>(2.0, 2.0, 2.0, 1.0), vec2<f32>(0.0), 0.0);
    }
    var clip = draw.clip_from_offset * vec4<f32>(at, 1.0);
    let reach = (draw.shape.y + 0.5) * offset;
    clip = vec4<f32>(clip.xy + reach / (0.5 * draw.viewport.xy) * clip.w, clip.zw);
    return Sprite(clip, reach, strength_at(at));
}

@fragment
fn point_fragment(in: Sprite) -> @location(0) vec4<f32> {
    let alpha = clamp(draw.shape.y + 0.5 - length(in.offset), 0.0, 1.0);
    // Corners must leave no trace in the depth buffer; rims are soft, so that small dots
    // are round, too.
    if alpha < 0.2 {
        discard;
    }
    return draw.fill * (in.brightness * alpha);
}

struct Surface {
    @builtin(position) position: vec4<f32>,
    @location(0) offset: vec3<f32>,
    @location(1) normal: vec3<f32>,
}

@vertex
fn triangle_vertex(@location(0) corner: vec3<f32>, @location(1) normal: vec3<f32>) -> Surface {
    let offset = draw.grid.xyz + corner;
    return Surface(draw.clip_from_offset * vec4<f32>(offset, 1.0), offset, normal);
}

@vertex
fn sphere_vertex(@location(0) normal: vec3<f32>, @location(1) sphere: vec4<f32>) -> Surface {
    let offset = draw.grid.xyz + sphere.xyz + sphere.w * normal;
    return Surface(draw.clip_from_offset * vec4<f32>(offset, 1.0), offset, normal);
}

@fragment
fn surface_fragment(in: Surface) -> @location(0) vec4<f32> {
    if before_slice(in.offset) > 0.0 {
        discard;
    }
    let brightness = lit(normalize(in.normal), in.offset);
    return vec4<f32>(draw.fill.rgb * brightness, draw.fill.a);
}
