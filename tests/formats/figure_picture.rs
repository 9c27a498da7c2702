//! A figure of a grid as a paper has it, drawn from its rows.

/// Pixels of a cell.
pub const CELL: usize = 12;
/// Pixels of white around the figure.
pub const MARGIN: usize = 20;

/// `.` is free, `@` a wall, `S` the start, `G` the goal, `?` half black.
pub const ROWS: [&str; 8] = ["S...@...", "..@.....", "..@@....", "@.......", "...@@@..", ".@......", ".@..@.@.", "....@..G"];

/// The rows as a PPM: gray lines between cells, black walls, a green start, a red goal.
pub fn ppm(rows: &[&str]) -> Vec<u8> {
    let (columns, side) = (rows[0].len(), |cells: usize| 2 * MARGIN + CELL * cells + 1);
    let (width, height) = (side(columns), side(rows.len()));
    let mut bytes = format!("P6\n{width} {height}\n255\n").into_bytes();
    for at in 0..width * height {
        bytes.extend(pixel(rows, at % width, at / width));
    }
    bytes
}

fn pixel(rows: &[&str], x: usize, y: usize) -> [u8; 3] {
    let inside = |at: usize, cells: usize| at >= MARGIN && at <= MARGIN + CELL * cells;
    if !inside(x, rows[0].len()) || !inside(y, rows.len()) {
        return [255; 3];
    }
    let (x, y) = (x - MARGIN, y - MARGIN);
    if x.is_multiple_of(CELL) || y.is_multiple_of(CELL) {
        return [128; 3];
    }
    match rows[y / CELL].as_bytes()[x / CELL] {
        b'@' => [0; 3],
        b'S' => [0, 160, 0],
        b'G' => [220, 20, 20],
        b'?' if x % CELL < CELL / 2 => [0; 3],
        _ => [255; 3],
    }
}
