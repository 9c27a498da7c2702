//! `--figure` and `--lattice`.
use super::figure_picture::{ROWS, ppm};
use super::folder::Folder;

fn with_figure(test: &str) -> Folder {
    let folder = Folder::with_map(test);
    std::fs::write(folder.0.join("figure.ppm"), ppm(&ROWS)).unwrap();
    folder
}

#[test]
fn figures_are_converted_and_planned_on() {
    let folder = with_figure("figure");
    folder.run(&["convert", "figure.ppm", "out.map", "--figure"]).ends(0).says(&["a lattice of 8 × 8 cells was found"]);
    let map = folder.read("out.map");
    let rows: Vec<String> = ROWS.iter().map(|row| row.replace(['S', 'G'], ".")).collect();
    assert_eq!(map.lines().skip(4).collect::<Vec<_>>(), rows);
    let plan = folder.run(&["plan", "figure.ppm", "--figure", "--planner", "astar", "--format", "json"]).ends(0).json();
    assert_eq!(
        (&plan["path"][0], plan["path"].as_array().unwrap().last()),
        (&serde_json::json!([0, 0]), Some(&serde_json::json!([7, 7])))
    );
    // The window of a figure is one of its cells.
    folder.run(&["convert", "figure.ppm", "part.csv", "--figure", "--crop", "0,0,4,2"]).ends(0);
    assert_eq!(folder.read("part.csv"), "0,0,0,0\n0,0,1,0\n");
    let lattice = ["convert", "figure.ppm", "given.map", "--figure", "--lattice", "20.5,20.5,12,12,8,8,0,0"];
    folder.run(&lattice).ends(0);
    assert_eq!(folder.read("given.map"), map);
}

#[test]
fn what_does_not_go_with_a_figure_is_refused_by_name() {
    let folder = with_figure("no-figure");
    let convert = |more: &[&str]| folder.run(&[&["convert", "figure.ppm", "out.map"], more].concat()).ends(2);
    for (option, value) in
        [("--threshold", "128"), ("--cells", "8"), ("--metres-per-pixel", "1"), ("--unknown", "free"), ("--matrix", "1")]
    {
        convert(&["--figure", option, value]).says(&["--figure", option, "cannot be used with"]);
    }
    convert(&["--lattice", "0,0,9,9,8,8"]).says(&["--figure"]);
    for lattice in ["0,0,9,9,8", "0,0,9,9,8,8,1", "0,0,9,9,8,x"] {
        convert(&["--figure", "--lattice", lattice]).says(&["is no lattice"]);
    }
    convert(&["--figure", "--lattice", "0,0,2,9,8,8"]).says(&["cells of at least 3 × 3 pixels"]);
    folder.run(&["convert", "small.map", "out.csv", "--figure"]).ends(2).says(&["figure: the file is no picture"]);
    std::fs::write(folder.0.join("blank.pgm"), [&b"P5\n40 40\n255\n"[..], &[255; 1600]].concat()).unwrap();
    let blank = folder.run(&["convert", "blank.pgm", "out.csv", "--figure"]).ends(2);
    blank.says(&["no lattice of cells is found", "--lattice", "--threshold"]);
}
