// Cells of the plane, snapped to pixels: one instance a cell.

struct Cell {
    @builtin(position) position: vec4<f32>,
    @location(0) colour: vec4<f32>,
    /// Left, top, right and bottom of the area inside the lines, in pixels.
    @location(1) @interpolate(flat, either) inside: vec4<f32>,
    @location(2) @interpolate(flat, either) line_alpha: f32,
}

/// Pixel column and row of a grid point: exact differences of integers first,
/// so that nothing trembles at any zoom.
fn pixel_from_code(code: vec2<i32>) -> vec2<f32> {
    let step = vec2<f32>(code - draw.reference.xy) * vec2<f32>(draw.grid.w, -draw.grid.w);
    return floor(draw.grid.xy + step + 0.5);
}

@vertex
fn cell_vertex(
    @builtin(vertex_index) index: u32,
    @location(0) packed: vec2<u32>,
    @location(1) colour: vec4<f32>,
) -> Cell {
    let code = vec2<i32>(decode(packed).xy);
    let side = i32(draw.shape.x);
    let low = pixel_from_code(code);
    let high = pixel_from_code(code + side);
    let line = draw.shape.y;
    // Rows run downwards: `high` is above `low`. The last line lies on the
    // neighbour's first one, so that every line is drawn once, and crisp.
    let left_top = vec2<f32>(low.x, high.y);
    let right_bottom = vec2<f32>(high.x, low.y);
    let pixel = mix(left_top, right_bottom + line, square_corner(index));
    let clip = (pixel / draw.viewport.xy * 2.0 - 1.0) * vec2<f32>(1.0, -1.0);
    // Lines of cells of a few pixels would cover what they divide.
    let size = draw.shape.x * draw.grid.w;
    let fade = clamp((size - 1.0) / 5.0, 0.0, 1.0);
    return Cell(
        vec4<f32>(clip, 0.0, 1.0),
        colour,
        vec4<f32>(left_top + line, right_bottom),
        fade,
    );
}

@fragment
fn cell_fragment(in: Cell) -> @location(0) vec4<f32> {
    let p = in.position.xy;
    let in_line = draw.shape.y > 0.0
        && (any(p < in.inside.xy) || any(p >= in.inside.zw));
    if !in_line {
        return in.colour;
    }
    // The faded line lies over the fill.
    let line = draw.edge * in.line_alpha;
    return line + in.colour * (1.0 - line.a);
}
