// Copies the finished picture into the interface, pixel by pixel.

@group(0) @binding(0) var picture: texture_2d<f32>;

struct Corner {
    @builtin(position) position: vec4<f32>,
    @location(0) place: vec2<f32>,
}

@vertex
fn blit_vertex(@builtin(vertex_index) index: u32) -> Corner {
    // One triangle that covers the square [0, 1]².
    let place = vec2<f32>(f32((index << 1u) & 2u), f32(index & 2u));
    return Corner(vec4<f32>(place.x * 2.0 - 1.0, 1.0 - place.y * 2.0, 0.0, 1.0), place);
}

fn texel(place: vec2<f32>) -> vec4<f32> {
    let size = vec2<i32>(textureDimensions(picture));
    let at = vec2<i32>(place * vec2<f32>(size));
    return textureLoad(picture, clamp(at, vec2<i32>(0), size - 1), 0);
}

@fragment
fn blit_gamma(in: Corner) -> @location(0) vec4<f32> {
    return texel(in.place);
}

/// For targets that encode what they are given.
@fragment
fn blit_linear(in: Corner) -> @location(0) vec4<f32> {
    let colour = texel(in.place);
    let low = colour.rgb / 12.92;
    let high = pow((colour.rgb + 0.055) / 1.055, vec3<f32>(2.4));
    return vec4<f32>(select(high, low, colour.rgb < vec3<f32>(0.04045)), colour.a);
}
