// What the tree is built over: points, triangles and spheres.

struct Sprite {
    @builtin(position) position: vec4<f32>,
    @location(0) offset: vec2<f32>,
    @location(1) brightness: f32,
}

@vertex
fn point_vertex(@builtin(vertex_index) index: u32, @location(0) world: vec3<f32>) -> Sprite {
    let offset = square_corner(index) * 2.0 - 1.0;
    if before_slice(world) > 0.0 {
        return Sprite(vec4<f32>(2.0, 2.0, 2.0, 1.0), vec2<f32>(0.0), 0.0);
    }
    var clip = draw.clip_from_world * vec4<f32>(world, 1.0);
    let reach = (draw.shape.y + 0.5) * offset;
    clip = vec4<f32>(clip.xy + reach / (0.5 * draw.viewport.xy) * clip.w, clip.zw);
    return Sprite(clip, reach, strength_at(world));
}

@fragment
fn point_fragment(in: Sprite) -> @location(0) vec4<f32> {
    let alpha = clamp(draw.shape.y + 0.5 - length(in.offset), 0.0, 1.0);
    // Corners must leave no trace in the depth buffer.
    if alpha < 0.5 {
        discard;
    }
    return draw.fill * in.brightness;
}

struct Surface {
    @builtin(position) position: vec4<f32>,
    @location(0) world: vec3<f32>,
    @location(1) normal: vec3<f32>,
}

@vertex
fn triangle_vertex(@location(0) world: vec3<f32>, @location(1) normal: vec3<f32>) -> Surface {
    return Surface(draw.clip_from_world * vec4<f32>(world, 1.0), world, normal);
}

@vertex
fn sphere_vertex(@location(0) normal: vec3<f32>, @location(1) sphere: vec4<f32>) -> Surface {
    let world = sphere.xyz + sphere.w * normal;
    return Surface(draw.clip_from_world * vec4<f32>(world, 1.0), world, normal);
}

@fragment
fn surface_fragment(in: Surface) -> @location(0) vec4<f32> {
    if before_slice(in.world) > 0.0 {
        discard;
    }
    let brightness = lit(normalize(in.normal), in.world);
    return vec4<f32>(draw.fill.rgb * brightness, draw.fill.a);
}
