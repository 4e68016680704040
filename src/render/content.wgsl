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

@fragment
fn surface_fragment(in: Surface) -> @location(0) vec4<f32> {
    if before_slice(in.offset) > 0.0 {
        discard;
    }
    let brightness = lit(normalize(in.normal), in.offset);
    return vec4<f32>(draw.fill.rgb * brightness, draw.fill.a);
}

/// A sphere: a square before it, of whose points each looks whether its ray meets the
/// sphere. So it is round at any size.
struct Ball {
    @builtin(position) position: vec4<f32>,
    @location(0) offset: vec3<f32>,
    /// Centre and radius.
    @location(1) @interpolate(flat, either) sphere: vec4<f32>,
}

@vertex
fn sphere_vertex(@builtin(vertex_index) index: u32, @location(0) sphere: vec4<f32>) -> Ball {
    let centre = draw.grid.xyz + sphere.xyz;
    let eye = towards_eye(centre);
    let aside = select(vec3<f32>(1.0, 0.0, 0.0), vec3<f32>(0.0, 0.0, 1.0), abs(eye.x) > 0.7);
    let right = normalize(cross(aside, eye));
    let up = cross(eye, right);
    // A near eye sees less than half of a sphere, and that wider than its radius. Without
    // a limit, the square of a sphere around the eye would have no end.
    let away = max(length(draw.eye.xyz - centre * draw.eye.w), 1.02 * sphere.w);
    let share = sphere.w / away * draw.eye.w;
    let wide = sphere.w / sqrt(1.0 - share * share);
    // A pixel more, for its soft rim.
    let pixel = pixel_at(centre, right);
    let place = (square_corner(index) * 2.0 - 1.0) * (wide + pixel);
    let offset = centre + place.x * right + place.y * up;
    return Ball(
        draw.clip_from_offset * vec4<f32>(offset, 1.0),
        offset,
        vec4<f32>(centre, sphere.w),
    );
}

/// About the length of a pixel at a point, across the view.
fn pixel_at(point: vec3<f32>, across: vec3<f32>) -> f32 {
    let clip = draw.clip_from_offset * vec4<f32>(point, 1.0);
    let step = (draw.clip_from_offset * vec4<f32>(across, 0.0)).xy;
    let pixels = length(step * 0.5 * draw.viewport.xy) / max(clip.w, 1e-6);
    return 1.0 / max(pixels, 1e-6);
}

struct Lit {
    @builtin(frag_depth) depth: f32,
    @location(0) colour: vec4<f32>,
}

@fragment
fn sphere_fragment(in: Ball) -> Lit {
    let radius = in.sphere.w;
    let off = in.offset - in.sphere.xyz;
    let ray = -towards_eye(in.offset);
    let middle = -dot(off, ray);
    let beside = length(off + middle * ray);
    let rim = max(fwidth(beside), 1e-12);
    let alpha = clamp((radius - beside) / rim + 0.5, 0.0, 1.0);
    // The nearer end of the ray in the sphere; the farther where that is cut off.
    let half = sqrt(max(radius * radius - beside * beside, 0.0));
    var at = in.offset + (middle - half) * ray;
    let is_behind_eye = dot(at * draw.eye.w - draw.eye.xyz, ray) < 0.0 && draw.eye.w > 0.0;
    if is_behind_eye || before_slice(at) > 0.0 {
        at = in.offset + (middle + half) * ray;
    }
    if alpha < 0.2 || before_slice(at) > 0.0 {
        discard;
    }
    let clip = draw.clip_from_offset * vec4<f32>(at, 1.0);
    let brightness = lit(normalize(at - in.sphere.xyz), at);
    let colour = vec4<f32>(draw.fill.rgb * brightness, draw.fill.a) * alpha;
    return Lit(clamp(clip.z / clip.w, 0.0, 1.0), colour);
}
