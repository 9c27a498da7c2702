//! Figures of grids as maps: by the lattice that is found or given, and what is refused by name.

use formicarium::error::ErrorReport;
use formicarium::formats::figure::{self, Lattice, class};
use formicarium::formats::picture::PictureOptions;
use formicarium::formats::{FigureOptions, Imported, ReadOptions, import_with};
use formicarium::map::Point;

use super::figure_picture::{CELL, MARGIN, ROWS, ppm};
use super::{notices, rows};

fn read(bytes: &[u8], options: &ReadOptions) -> Result<Imported, ErrorReport> {
    import_with(bytes, "papers/figure.png", options, None).map_err(|error| error.report())
}

fn as_figure(lattice: Option<Lattice>) -> ReadOptions {
    ReadOptions { figure: Some(FigureOptions { lattice }), ..Default::default() }
}

/// The upper left part of the figure.
fn lattice(columns: u32, rows: u32) -> Lattice {
    let (corner, side) = (MARGIN as f64 + 0.5, CELL as f64);
    Lattice { x0: corner, y0: corner, dx: side, dy: side, shear_x: 0.0, shear_y: 0.0, columns, rows }
}

/// The rows with free ends.
fn cells(figure: &[&str]) -> Vec<String> {
    figure.iter().map(|row| row.replace(['S', 'G'], ".").replace('?', "@")).collect()
}

#[test]
fn the_cells_and_ends_of_a_figure_are_the_map() {
    let map = read(&ppm(&ROWS), &as_figure(None)).unwrap();
    assert_eq!(rows(&map.grid), cells(&ROWS));
    assert_eq!((map.spec.start, map.spec.goals[0].at, &map.spec.name[..]), (Point::new(0, 0), Point::new(7, 7), "figure"));
    assert_eq!(notices(&map), ["figure-lattice", "figure-cells"]);
    let by_hand = read(&ppm(&ROWS), &as_figure(Some(lattice(8, 8)))).unwrap();
    assert_eq!((rows(&by_hand.grid), notices(&by_hand)), (cells(&ROWS), vec!["figure-cells"]));
}

#[test]
fn a_part_may_lack_ends_and_what_is_unsure_is_blocked_and_told() {
    let mut figure = ROWS;
    figure[3] = "@..?....";
    let options = ReadOptions {
        picture: PictureOptions { metres_per_cell: Some(0.5), ..Default::default() },
        ..as_figure(Some(lattice(6, 4)))
    };
    let map = read(&ppm(&figure), &options).unwrap();
    let part: Vec<&str> = figure[..4].iter().map(|row| &row[..6]).collect();
    assert_eq!((rows(&map.grid), map.spec.resolution), (cells(&part), 0.5));
    assert_eq!((map.spec.start, map.ends_were_chosen()), (Point::new(0, 0), true));
    assert!(notices(&map).contains(&"figure-unsure-blocked"), "{:?}", map.notices);
}

#[test]
fn what_cannot_be_a_figure_is_refused_by_name() {
    let field = |bytes: &[u8], options: &ReadOptions| {
        let ErrorReport { kind, field, hint, .. } = read(bytes, options).unwrap_err();
        assert_eq!(kind, "bad-field");
        (field, hint)
    };
    let blank = ppm(&["......"; 3]).iter().map(|&byte| if byte == 128 { 255 } else { byte }).collect::<Vec<_>>();
    let (name, hint) = field(&blank, &as_figure(None));
    assert!(name == "figure" && hint.contains("give its lattice") && hint.contains("threshold"), "{hint}");
    for text in ["0 0\n0 1\n", "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2\n3 4\n"] {
        assert_eq!(field(text.as_bytes(), &as_figure(None)).0, "figure");
    }
    assert_eq!(field(&ppm(&ROWS), &as_figure(Some(Lattice { dx: 2.0, ..lattice(8, 8) }))).0, "dx");
    let usual = PictureOptions::default();
    for (name, picture) in [
        ("threshold", PictureOptions { threshold: Some(9), ..usual.clone() }),
        ("light_is_blocked", PictureOptions { light_is_blocked: true, ..usual.clone() }),
        ("cells", PictureOptions { cells: Some(8), ..usual.clone() }),
        ("metres_per_pixel", PictureOptions { metres_per_pixel: Some(1.0), ..usual.clone() }),
        ("metres_per_cell", PictureOptions { metres_per_cell: Some(0.0), ..usual.clone() }),
    ] {
        assert_eq!(field(&ppm(&ROWS), &ReadOptions { picture, ..as_figure(None) }).0, name);
    }
}

#[test]
fn cells_that_were_corrected_are_checked() {
    let wrong = |classes: &[u8], columns| figure::to_map(classes, columns, "x").unwrap_err().report();
    for (classes, columns) in [(&[0; 5][..], 2), (&[0; 4], 0), (&[0, 0, 9, 0], 2), (&[2, 0, 2, 0], 2), (&[3, 3, 0, 0], 2)] {
        assert_eq!(wrong(classes, columns).field, "classes", "{classes:?}");
    }
    assert_eq!(wrong(&[class::WALL; 4], 2).kind, "no-free-cell");
    let map = figure::to_map(&[class::PATH, class::GOAL, class::START, class::UNSURE], 2, "x.png").unwrap();
    assert_eq!((rows(&map.grid), map.spec.start), (vec!["..".to_string(), ".@".into()], Point::new(0, 1)));
}
