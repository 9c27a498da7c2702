//! What ground costs, as files tell it: swamp of MovingAI maps, costmaps of ROS; and what becomes of it on the way out.

use formicarium::error::ErrorReport;
use formicarium::formats::ros::Costs;
use formicarium::formats::{Companion, Export, Imported, ReadOptions, TerrainOptions, export, import_with};
use formicarium::map::Window;
use formicarium::scenario::CostRule;

use super::{notices, rows};

const SWAMP: &str = "type octile\nheight 3\nwidth 4\nmap\n.@.G\nO.TS\nS..W\n";

fn read(text: &str, options: &ReadOptions) -> Result<Imported, ErrorReport> {
    import_with(text.as_bytes(), "test", options, None).map_err(|error| error.report())
}

fn swamp(factor: f32) -> ReadOptions {
    ReadOptions { swamp_factor: Some(factor), ..ReadOptions::default() }
}

fn costs(rule: CostRule) -> ReadOptions {
    ReadOptions { costs: Some(Costs::by(rule)), ..ReadOptions::default() }
}

#[test]
fn swamp_costs_what_is_asked_for() {
    let plain = read(SWAMP, &ReadOptions::default()).unwrap();
    assert!(plain.grid.factors().is_none() && notices(&plain).contains(&"swamp"));
    assert!(plain.notices.iter().any(|notice| notice.message.contains("swamp_factor")), "the option is named");
    let dear = read(SWAMP, &swamp(2.5)).unwrap();
    assert_eq!(dear.grid.factors().unwrap()[..], [1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 2.5, 2.5, 1.0, 1.0, 1.0]);
    assert_eq!((rows(&dear.grid), notices(&dear)), (rows(&plain.grid), vec!["swamp-factor", "water", "ends-chosen"]));
    assert_eq!(read(SWAMP, &swamp(1.0)).unwrap().grid, plain.grid, "a factor of 1 is plain ground");
    // Beside emitters S is a station.
    let robots = read(&SWAMP.replace('G', "E"), &swamp(2.5)).unwrap();
    assert!(robots.grid.factors().is_none() && notices(&robots).contains(&"map-stations"));
    for wrong in [0.5, -1.0, 1001.0, f32::NAN, f32::INFINITY] {
        assert_eq!(read(SWAMP, &swamp(wrong)).unwrap_err().field, "swamp_factor", "{wrong}");
    }
}

/// A message of one row.
fn message(data: &[i32]) -> String {
    let origin = r#"{"position": {"x": 0, "y": 0}}"#;
    format!(r#"{{"info": {{"resolution": 1, "width": {}, "height": 1, "origin": {origin}}}, "data": {data:?}}}"#, data.len())
}

#[test]
fn a_published_costmap_has_its_costs_again() {
    // Costmap2DPublisher of Nav2: 0, 1 to 252 as 1 + 97·(c − 1) / 251, 253, 254 and 255.
    let published = message(&[0, 1, 50, 98, 99, 100, -1, 0]);
    let smac = read(&published, &costs(CostRule::Nav2Smac2d)).unwrap();
    assert_eq!(rows(&smac.grid), ["....@@@."]);
    // 1 + 2·c / 252 of the smallest cost that is published so: 1, 128 (97·127 / 251 = 49.08), 252.
    let factor = |cost: f64| (1.0 + 2.0 * cost / 252.0) as f32;
    let expected = [1.0, factor(1.0), factor(128.0), factor(252.0), 1.0, 1.0, 1.0, 1.0];
    assert_eq!(smac.grid.factors().unwrap()[..], expected);
    let navfn = read(&published, &costs(CostRule::Nav2Navfn)).unwrap();
    assert_eq!(navfn.grid.factors().unwrap()[..4], [1.0, 1.0, 3.04, 5.02], "⌊50 + 0.8·c⌋ / 50");
    assert!(notices(&smac).contains(&"costs-read") && !notices(&smac).contains(&"costs-unread"));
    let none = read(&message(&[0, 100, -1, 0]), &costs(CostRule::Nav2Smac2d)).unwrap();
    assert!(none.grid.factors().is_none() && notices(&none).contains(&"costs-none"));
    let steep = ReadOptions { costs: Some(Costs { multiplier: 501.0, ..Costs::by(CostRule::Nav2Smac2d) }), ..Default::default() };
    assert_eq!(read(&published, &steep).unwrap_err().field, "multiplier");
}

#[test]
fn values_between_that_nobody_asks_about_are_told_once_and_count_as_before() {
    let map = read(&message(&[0, 10, 24, 25, 66, 100]), &ReadOptions::default()).unwrap();
    assert_eq!((rows(&map.grid), map.grid.factors().is_none()), (vec!["...@@@".to_owned()], true));
    let told: Vec<_> = map.notices.iter().filter(|notice| notice.kind == "costs-unread").collect();
    assert_eq!((told.len(), told[0].args["count"].as_str()), (1, "4"));
    let trinary = read(&message(&[0, 100, -1, 0]), &ReadOptions::default()).unwrap();
    assert!(!notices(&trinary).contains(&"costs-unread"));
}

fn picture(mode: &str, grays: &[u8], options: &ReadOptions) -> Imported {
    let yaml = format!(
        "image: a.pgm\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.25\nmode: {mode}\n"
    );
    let pgm = [format!("P5\n{} 1\n255\n", grays.len()).as_bytes(), grays].concat();
    import_with(yaml.as_bytes(), "a.yaml", options, Some(Companion { name: "a.pgm", bytes: &pgm })).unwrap()
}

#[test]
fn pictures_hold_costs_in_the_modes_that_have_values_between() {
    let smac = costs(CostRule::Nav2Smac2d);
    // Raw: the gray is the value, above 100 unknown.
    let raw = picture("raw", &[0, 98, 99, 100, 101, 0], &smac);
    assert_eq!((rows(&raw.grid), raw.grid.factors().unwrap()[1]), (vec!["..@@@.".to_owned()], 3.0));
    // Scale: 127 is 128/255 = 0.502 occupied, (0.502 − 0.25) / 0.4 = 0.63: 63 of 100.
    let scale = picture("scale", &[254, 127, 0, 254], &smac);
    let cost = 1.0 + (251.0 * 62.0 / 97.0_f64).ceil();
    assert_eq!(
        (rows(&scale.grid), scale.grid.factors().unwrap()[1]),
        (vec!["..@.".to_owned()], (1.0 + 2.0 * cost / 252.0) as f32)
    );
    assert!(notices(&picture("scale", &[254, 127, 0], &ReadOptions::default())).contains(&"costs-unread"));
    let trinary = picture("trinary", &[254, 127, 0], &smac);
    assert!(trinary.grid.factors().is_none() && notices(&trinary).contains(&"costs-none"));
    assert!(!notices(&picture("trinary", &[254, 127, 0], &ReadOptions::default())).contains(&"costs-unread"));
    // Fewer cells are as dear as the dearest, and unknown ones worse than any cost.
    let fewer = ReadOptions { cells: Some(2), ..smac };
    let shrunk = picture("raw", &[0, 98, 1, 0], &fewer);
    assert_eq!(shrunk.grid.factors().unwrap()[..], [3.0, (1.0 + 2.0 / 252.0) as f32]);
    assert_eq!(rows(&picture("raw", &[0, 98, 98, 101], &fewer).grid), [".@"]);
}

#[test]
fn pieces_keep_their_factors_and_a_file_all_of_them() {
    let map = read(SWAMP, &swamp(2.5)).unwrap();
    let text = export(&map.grid, &map.spec, Export::Scenario);
    assert_eq!(read(&text, &ReadOptions::default()).unwrap().grid, map.grid);
    let window = Window { x: 2, y: 0, width: 2, height: 2 };
    let cut = map.clone().piece(TerrainOptions { crop: Some(window), size: None }).unwrap();
    assert_eq!(cut.grid.factors().unwrap()[..], [1.0, 1.0, 1.0, 2.5]);
    let larger = cut.piece(TerrainOptions { crop: None, size: Some((4, 4)) }).unwrap();
    assert_eq!(larger.grid.factors().unwrap()[8..12], [1.0, 1.0, 2.5, 2.5]);
    let without = Window { x: 1, y: 1, width: 1, height: 1 };
    let plain = map.piece(TerrainOptions { crop: Some(without), size: None }).unwrap();
    assert!(plain.grid.factors().is_none(), "a piece of plain ground is plain");
}
