//! MovingAI `.map`: four header lines (`type`, `height`, `width`, `map`), then one line of terrain letters per row.
//!
//! `.` `G` `S` are passable, `@` `O` `T` `W` are not; so is `E`, an emitter in the maps of the League of Robot Runners. Maps of type
//! `octile-corner` (Warcraft III) have the heights of the corners before the cells; these are left out.
//! Swamp (`S`) may be given a factor, by which a way through it counts; the format itself only says that it is passable from ground. Water
//! (`W`) is for who comes over water: from the ground, where every way begins, it is blocked. A notice says so where they occur.

use super::text::{lines, quote};
use crate::error::{FormatError, Notice, ScenarioError};
use crate::map::{Grid, MAX_FACTOR, MAX_SIDE, Point, check_size};

/// Header lines that are looked at before a file is given up.
const HEADER_LINES: usize = 20;

/// A `.map` file as read.
pub(super) struct MapFile {
    pub grid: Grid,
    pub notices: Vec<Notice>,
}

/// What the header says.
#[derive(Default)]
struct Header {
    kind: Option<String>,
    height: Option<u64>,
    width: Option<u64>,
}

/// Whether the text begins like a `.map`: a header line, and another one or the line `map` soon after.
pub(super) fn looks_like(text: &str) -> bool {
    let mut head = lines(text).map(|(_, l)| l.trim()).filter(|l| !l.is_empty()).take(HEADER_LINES);
    let is_header = |line: &str| {
        let mut words = line.split_whitespace();
        let key = words.next().unwrap_or_default().to_ascii_lowercase();
        matches!(key.as_str(), "type" | "height" | "width") && words.next().is_some_and(|value| value != "=")
    };
    head.next().is_some_and(is_header) && head.any(|l| l.eq_ignore_ascii_case("map") || is_header(l))
}

/// Reads a `.map`; `swamp` is the factor of its swamp.
///
/// # Errors
/// [`FormatError`] with the line at fault, or `swamp_factor`; sizes are refused before anything is allocated.
pub(super) fn read(text: &str, swamp: Option<f32>) -> Result<MapFile, FormatError> {
    if let Some(factor) = swamp.filter(|factor| !(1.0..=MAX_FACTOR).contains(factor)) {
        return Err(FormatError::field("swamp_factor", factor.to_string(), format!("a number from 1 to {MAX_FACTOR}")));
    }
    let mut lines = lines(text);
    let (header, map_line) = read_header(&mut lines)?;
    let (mut width, mut height) = header.size(map_line)?;
    let mut lines = lines.peekable();
    let corners = if header.has_corners() { Some(skip_corners(&mut lines, &mut width, &mut height)?) } else { None };
    let mut cells = Vec::with_capacity(width as usize * height as usize);
    let mut terrain = Terrain::default();
    let mut last = map_line;
    for row in 0..height {
        let Some((number, line)) = lines.next() else { return Err(too_few_rows(last, row, height)) };
        let line = line.trim_end();
        if line.is_empty() {
            return Err(too_few_rows(number, row, height));
        }
        read_row(number, line, width, &mut terrain, &mut cells)?;
        last = number;
    }
    if let Some((number, line)) = lines.find(|(_, l)| !l.trim().is_empty()) {
        let what = format!("`{}` follows after the last of {height} rows", quote(line));
        return Err(FormatError::syntax(number, what, "the end of the file, or a larger `height`"));
    }
    let grid = Grid::from_bytes(width, height, &cells)?;
    let grid = match swamp.filter(|_| terrain.has_swamp()) {
        Some(factor) => grid.with_factors(terrain.factors(cells.len(), factor))?,
        None => grid,
    };
    let notices = header.notice().into_iter().chain(corners).chain(terrain.notices(swamp)).collect();
    Ok(MapFile { grid, notices })
}

/// Reads up to the line `map`; header lines may stand in any order and in any case.
fn read_header<'a>(lines: &mut impl Iterator<Item = (usize, &'a str)>) -> Result<(Header, usize), FormatError> {
    const EXPECTED: &str = "`type octile`, `height N`, `width N`, then `map`";
    let mut header = Header::default();
    let mut last = 0;
    for (number, line) in lines.by_ref().take(HEADER_LINES) {
        last = number;
        let mut words = line.split_whitespace();
        let (Some(key), value) = (words.next(), words.next()) else { continue };
        match (key.to_ascii_lowercase().as_str(), value) {
            ("map", None) => return Ok((header, number)),
            ("type", Some(kind)) => set(&mut header.kind, kind.to_string(), number, key)?,
            ("height", Some(n)) => set(&mut header.height, side(n, number)?, number, key)?,
            ("width", Some(n)) => set(&mut header.width, side(n, number)?, number, key)?,
            _ => return Err(FormatError::syntax(number, format!("`{}` is no header line", quote(line)), EXPECTED)),
        }
    }
    Err(FormatError::syntax(last, "the header does not end with `map`", EXPECTED))
}

fn set<T>(place: &mut Option<T>, value: T, line: usize, key: &str) -> Result<(), FormatError> {
    match place.replace(value) {
        None => Ok(()),
        Some(_) => Err(FormatError::syntax(line, format!("`{}` stands twice", quote(key)), "each header line once")),
    }
}

fn side(text: &str, line: usize) -> Result<u64, FormatError> {
    let wrong = || FormatError::syntax(line, format!("`{}` is no whole number", quote(text)), "a number of cells, e.g. 512");
    if text.bytes().all(|b| b.is_ascii_digit()) {
        // Digits that overflow are a size all the same, and refused as one.
        Ok(text.parse().unwrap_or(u64::MAX))
    } else {
        Err(wrong())
    }
}

impl Header {
    fn size(&self, map_line: usize) -> Result<(u32, u32), FormatError> {
        let missing =
            |key| FormatError::syntax(map_line, format!("the header names no `{key}`"), format!("a line `{key} N` above"));
        let width = self.width.ok_or_else(|| missing("width"))?;
        let height = self.height.ok_or_else(|| missing("height"))?;
        check_size(width, height)?;
        let narrow = |n| u32::try_from(n).map_err(|_| ScenarioError::MapSize { width, height, most: MAX_SIDE });
        Ok((narrow(width)?, narrow(height)?))
    }

    /// Whether heights of the corners stand before the cells: the maps of Warcraft III.
    fn has_corners(&self) -> bool {
        self.kind.as_deref().is_some_and(|kind| kind.eq_ignore_ascii_case("octile-corner"))
    }

    fn notice(&self) -> Option<Notice> {
        let kind = self.kind.as_deref().unwrap_or("missing");
        (!kind.eq_ignore_ascii_case("octile") && !self.has_corners()).then(|| {
            Notice::new("map-type", format!("the map's type is `{}`; it was read as `octile`", quote(kind)))
                .with("value", quote(kind))
        })
    }
}

/// Leaves out the rows of corner heights, digits all of them. The header's size is theirs or that of the cells, which are one fewer a side;
/// afterwards it is that of the cells.
fn skip_corners<'a>(
    lines: &mut std::iter::Peekable<impl Iterator<Item = (usize, &'a str)>>,
    width: &mut u32,
    height: &mut u32,
) -> Result<Notice, FormatError> {
    let is_corners = |line: &str| !line.is_empty() && line.bytes().all(|b| b.is_ascii_hexdigit());
    let (mut rows, mut columns) = (0u32, 0u32);
    while let Some((_, line)) = lines.next_if(|(_, line)| is_corners(line.trim_end())) {
        (rows, columns) = (rows.saturating_add(1), u32::try_from(line.trim_end().len()).unwrap_or(u32::MAX));
    }
    let line = lines.peek().map_or(0, |(line, _)| *line);
    if (columns, rows) == (*width, *height) && rows > 1 && columns > 1 {
        (*width, *height) = (*width - 1, *height - 1);
    } else if (columns, rows) != (width.saturating_add(1), height.saturating_add(1)) {
        let what = format!("{rows} rows of {columns} corner heights stand before the cells");
        return Err(FormatError::syntax(line, what, "as many corners as the header says, or one more a side"));
    }
    let message = format!("the heights of {columns} × {rows} corners were left out: only the cells between them were read");
    Ok(Notice::new("map-corners", message).with("columns", columns).with("rows", rows))
}

fn too_few_rows(line: usize, row: u32, height: u32) -> FormatError {
    FormatError::syntax(line, format!("the map ends after {row} of {height} rows"), "one line for each row")
}

/// How often each unusual terrain was seen, and where the swamp lies.
#[derive(Default)]
struct Terrain {
    swamp: Vec<usize>,
    water: usize,
    emitters: usize,
}

impl Terrain {
    /// 1 = blocked, 0 = free; none for a letter that is no terrain.
    fn cell(&mut self, letter: u8, at: usize) -> Option<u8> {
        match letter.to_ascii_uppercase() {
            b'.' | b'G' => Some(0),
            b'@' | b'O' | b'T' => Some(1),
            b'S' => {
                self.swamp.push(at);
                Some(0)
            }
            b'E' => {
                self.emitters += 1;
                Some(0)
            }
            b'W' => {
                self.water += 1;
                Some(1)
            }
            _ => None,
        }
    }

    /// Where there are emitters, S is a station beside them and not swamp.
    fn has_swamp(&self) -> bool {
        self.emitters == 0 && !self.swamp.is_empty()
    }

    /// One factor a cell of so many: that of swamp, else 1.
    fn factors(&self, cells: usize, swamp: f32) -> Vec<f32> {
        let mut factors = vec![1.0; cells];
        self.swamp.iter().for_each(|&at| factors[at] = swamp);
        factors
    }

    /// The notice about swamp, which has a factor or not.
    fn swamp_notice(&self, factor: Option<f32>) -> Notice {
        let count = self.swamp.len();
        match factor {
            Some(factor) => {
                let message = format!("{count} cells of swamp (S) have the factor {factor}");
                Notice::new("swamp-factor", message).with("count", count).with("factor", factor)
            }
            None => {
                let message = format!(
                    "{count} cells of swamp (S) were read as free; a factor makes them dearer: `swamp_factor` (--swamp-factor)"
                );
                Notice::new("swamp", message).with("count", count)
            }
        }
    }

    fn notices(&self, swamp: Option<f32>) -> impl Iterator<Item = Notice> + use<> {
        let water = (self.water > 0).then(|| {
            let message = format!("{} cells of water (W) were read as blocked: no way leads into it from the ground", self.water);
            Notice::new("water", message).with("count", self.water)
        });
        let robots = (self.emitters > 0).then(|| {
            let (emitters, stations) = (self.emitters, self.swamp.len());
            let message = format!("{emitters} emitters (E) and {stations} stations (S) were read as free");
            Notice::new("map-stations", message).with("emitters", emitters).with("stations", stations)
        });
        let swamp = self.has_swamp().then(|| self.swamp_notice(swamp));
        [swamp, robots, water].into_iter().flatten()
    }
}

fn read_row(number: usize, line: &str, width: u32, terrain: &mut Terrain, cells: &mut Vec<u8>) -> Result<(), FormatError> {
    for (column, letter) in line.char_indices().take(width as usize) {
        let Some(cell) = u8::try_from(letter).ok().and_then(|b| terrain.cell(b, cells.len())) else {
            let what = format!("`{letter}` in column {column} is no terrain");
            return Err(FormatError::syntax(number, what, ". G S E (free) or @ O T W (blocked)"));
        };
        cells.push(cell);
    }
    let got = line.chars().count();
    if got == width as usize {
        return Ok(());
    }
    let what = format!("the row has {got} cells where the width is {width}");
    Err(FormatError::syntax(number, what, format!("{width} terrain letters")))
}

/// The map as a `.map` file.
pub(super) fn write(grid: &Grid) -> String {
    let mut text = format!("type octile\nheight {}\nwidth {}\nmap\n", grid.height(), grid.width());
    for row in rows(grid) {
        text.push_str(&row);
        text.push('\n');
    }
    text
}

/// Each row as `.` (free) and `@` (blocked).
pub(super) fn rows(grid: &Grid) -> impl Iterator<Item = String> + '_ {
    let letter = |p| if grid.is_blocked(grid.cell(p)) { '@' } else { '.' };
    (0..grid.height()).map(move |y| (0..grid.width()).map(|x| letter(Point::new(x, y))).collect())
}
