use super::*;

/// An instance from the lines behind its type.
fn read(lines: &str) -> Result<OrderProblem, FormatError> {
    read_instance(format!("NAME: t\nTYPE: TSP\n{lines}").as_bytes())
}

/// Costs from place 1 to 2, 1 to 3 and 2 to 3.
fn three(lines: &str) -> [f64; 3] {
    let costs = read(lines).unwrap_or_else(|error| panic!("{lines}: {error}")).costs;
    [costs.get(0, 1), costs.get(0, 2), costs.get(1, 2)]
}

fn refusal(lines: &str) -> String {
    let report = read(lines).unwrap_err().report();
    assert!(!report.hint.is_empty(), "{report:?}");
    format!("{}: {} ({})", report.field, report.message, report.hint)
}

const EXPLICIT: &str = "DIMENSION: 3\nEDGE_WEIGHT_TYPE: EXPLICIT\nEDGE_WEIGHT_FORMAT: ";
const FLAT: &str = "DIMENSION: 3\nEDGE_WEIGHT_TYPE: EUC_2D\nNODE_COORD_SECTION\n";

#[test]
fn every_form_of_a_matrix_gives_the_same_costs() {
    for (form, numbers) in [
        ("FULL_MATRIX", "9 1 2\n1 9 3\n2 3 9"),
        ("UPPER_ROW", "1 2\n3"),
        ("LOWER_ROW", "1\n2 3"),
        ("UPPER_DIAG_ROW", "0 1 2\n0 3\n0"),
        ("LOWER_DIAG_ROW", "0\n1 0\n2 3 0"),
        ("UPPER_COL", "1\n2 3"),
        ("LOWER_COL", "1 2 3"),
        ("UPPER_DIAG_COL", "0 1 0 2 3 0"),
        ("LOWER_DIAG_COL", "0 1\n2 0 3 0"),
    ] {
        assert_eq!(three(&format!("{EXPLICIT}{form}\nEDGE_WEIGHT_SECTION\n{numbers}\nEOF\n")), [1.0, 2.0, 3.0], "{form}");
    }
    // Four places: rows differ in length, and 1 to 4 are told apart.
    let upper =
        "DIMENSION: 4\nEDGE_WEIGHT_TYPE: EXPLICIT\nEDGE_WEIGHT_FORMAT: UPPER_ROW\nEDGE_WEIGHT_SECTION\n12 13 14 23 24 34\n";
    let costs = read(upper).unwrap().costs;
    assert_eq!([costs.get(0, 3), costs.get(1, 2), costs.get(3, 1), costs.get(3, 2)], [14.0, 23.0, 24.0, 34.0]);
}

#[test]
fn every_metric_rounds_as_the_format_says() {
    // (0, 0), (1, 1), (3, 0.4): √2 = 1.41, 3.03 and 2.09.
    let at = "1 0 0\n2 1 1\n3 3 0.4\n";
    let by = |metric: &str| three(&format!("DIMENSION: 3\nEDGE_WEIGHT_TYPE: {metric}\nNODE_COORD_SECTION\n{at}EOF\n"));
    assert_eq!(by("EUC_2D"), [1.0, 3.0, 2.0]);
    assert_eq!(by("CEIL_2D"), [2.0, 4.0, 3.0]);
    assert_eq!(by("MAN_2D"), [2.0, 3.0, 3.0]);
    assert_eq!(by("MAX_2D"), [1.0, 3.0, 2.0]);
    // √(2 / 10) = 0.45 and √(9.16 / 10) = 0.96: rounded, then up where that was down.
    assert_eq!(by("ATT"), [1.0, 1.0, 1.0]);
    let solid = |metric: &str| {
        three(&format!("DIMENSION: 3\nEDGE_WEIGHT_TYPE: {metric}\nNODE_COORD_SECTION\n1 0 0 0\n2 2 3 6\n3 0 0 4\nEOF\n"))
    };
    assert_eq!(solid("EUC_3D"), [7.0, 4.0, 4.0]);
    assert_eq!(solid("MAN_3D"), [11.0, 4.0, 7.0]);
    assert_eq!(solid("MAX_3D"), [6.0, 4.0, 3.0]);
    // A degree of a globe of 6378.388 km is 111.324 km: √2 of them are 157.4; the format adds 1 and cuts off.
    assert_eq!(by("GEO")[0], 158.0);
}

#[test]
fn layouts_in_use_are_read() {
    let made_up = "NAME : five\r\nTYPE : TSP (made up)\r\nDIMENSION :3\r\nEDGE_WEIGHT_TYPE\t: EUC_2D\r\nNODE_COORD_SECTION:\r\n\
                   2 5.0e0 1\r\n 1\t1 +1\r\n\r\n3 9 3\r\n";
    let problem = read_instance(made_up.as_bytes()).unwrap();
    assert_eq!((problem.name.as_str(), problem.len(), problem.shape), ("five", 3, Shape::Closed));
    assert_eq!(problem.places, Some(vec![[1.0, 1.0], [5.0, 1.0], [9.0, 3.0]]));
    let directed = "NAME: d.atsp\nTYPE: ATSP\nCOMMENT: one\nCOMMENT: two\nDIMENSION: 2\nEDGE_WEIGHT_TYPE: EXPLICIT\n\
                    EDGE_WEIGHT_FORMAT: FULL_MATRIX\nEDGE_WEIGHT_SECTION\n9999 1 2 9999\nEOF";
    let problem = read_instance(directed.as_bytes()).unwrap();
    assert_eq!((problem.name.as_str(), problem.comment.as_str()), ("d", "one two"));
    assert_eq!((problem.costs.get(0, 1), problem.costs.get(1, 0), problem.places), (1.0, 2.0, None));
    let shown = format!(
        "{EXPLICIT}UPPER_ROW\nDISPLAY_DATA_TYPE: TWOD_DISPLAY\nEDGE_WEIGHT_SECTION\n1 2 3\nDISPLAY_DATA_SECTION\n1 0 0\n3 2 2\n2 1 1\n"
    );
    assert_eq!(read(&shown).unwrap().places, Some(vec![[0.0, 0.0], [1.0, 1.0], [2.0, 2.0]]));
}

#[test]
fn what_is_not_read_is_refused_by_name() {
    let typed = |kind: &str| read_instance(format!("NAME: x\nTYPE: {kind}\nDIMENSION: 3\n").as_bytes()).unwrap_err().to_string();
    assert!(typed("CVRP").contains("vehicle routing"));
    assert!(typed("SOP").contains("sequential ordering"));
    assert!(typed("HCP").contains("Hamiltonian"));
    assert!(typed("tsp").contains("`tsp` is not known"));
    assert!(typed("TSP and more").contains("`and more` follows"));
    for (lines, said) in [
        ("EDGE_WEIGHT_TYPE: EUC_2D\n", "DIMENSION: is missing"),
        ("DIMENSION: 3\n", "EDGE_WEIGHT_TYPE: is missing"),
        ("DIMENSION: 3\nEDGE_WEIGHT_TYPE: EUC_2D\n", "NODE_COORD_SECTION: is missing"),
        ("DIMENSION: 1001\nEDGE_WEIGHT_TYPE: EUC_2D\n", "1001 places are too many"),
        ("DIMENSION: 1\nEDGE_WEIGHT_TYPE: EUC_2D\n", "from 2 to 1000"),
        ("DIMENSION: -3\n", "from 2 to 1000"),
        ("DIMENSION: 3\nDIMENSION: 3\n", "DIMENSION a second time"),
        ("DIMENSION: 3\nEDGE_WEIGHT_TYPE: XRAY1\n", "`XRAY1` is not read"),
        ("DIMENSION: 3\nEDGE_WEIGHT_TYPE: SPECIAL\n", "`SPECIAL` is not read"),
        ("dimension: 3\n", "`dimension: 3` is no key"),
        ("DIMENSION 3\n", "`DIMENSION 3` is no key"),
        ("DIMENSION: 3\nEDGE_WEIGHT_TYPE: EUC_2D\nFIXED_EDGES_SECTION\n1 2\n-1\n", "FIXED_EDGES_SECTION is not read"),
    ] {
        let refused = refusal(lines);
        assert!(refused.contains(said), "{lines}\n{refused}");
    }
}

#[test]
fn places_and_costs_must_be_all_there_once() {
    for (rest, said) in [
        ("1 0 0\n2 1 1\n", "lists 2 places, DIMENSION says 3"),
        ("1 0 0\n2 1 1\n2 1 1\n", "line 8: place 2 a second time"),
        ("1 0 0\n2 1 1\n4 1 1\n", "`4` is no place"),
        ("1 0 0\n2 1 1\n3 1\n", "a coordinate is missing"),
        ("1 0 0\n2 1 1\n3 1 1 1\n", "more than its coordinates"),
        ("1 0 0\n2 1 nan\n3 1 1\n", "line 7: `nan` is no number"),
        ("1 0 0\n2 1 inf\n3 1 1\n", "`inf` is no number"),
        ("1 0 0\n2 1 1e300\n3 1 1\n", "`1e300` is no number"),
        ("1 0 0\n2 1 1\n3 1 1\nEOF\nmore\n", "line 10: `more` stands behind EOF"),
        ("1 0 0\n2 1 1\n3 1 1\nCOMMENT: late\n", "COMMENT stands behind NODE_COORD_SECTION"),
        ("1 0 0\n2 1 1\n3 1 1\nNODE_COORD_SECTION\n", "NODE_COORD_SECTION a second time"),
        ("1 0 0\n2 1 1\n3 1 1\nEDGE_WEIGHT_SECTION\n1 2 3\n", "without EDGE_WEIGHT_TYPE: EXPLICIT"),
    ] {
        let refused = refusal(&format!("{FLAT}{rest}"));
        assert!(refused.contains(said), "{rest}\n{refused}");
    }
    for (rest, said) in [
        ("FULL_MATRIX\nEDGE_WEIGHT_SECTION\n0 1 2 1 0 3 2 4 0\n", "from place 2 to 3 costs 3, back 4"),
        ("UPPER_ROW\nEDGE_WEIGHT_SECTION\n1 2\n", "has 2 costs"),
        ("UPPER_ROW\nEDGE_WEIGHT_SECTION\n1 2 3 4\n", "`4` is one cost too many"),
        ("UPPER_ROW\nEDGE_WEIGHT_SECTION\n1 -2 3\n", "-2 is below 0"),
        ("UPPER_ROW\n", "EDGE_WEIGHT_SECTION: is missing"),
        ("WEIGHT_LIST\nEDGE_WEIGHT_SECTION\n1 2 3\n", "`WEIGHT_LIST` is not read"),
    ] {
        let refused = refusal(&format!("{EXPLICIT}{rest}"));
        assert!(refused.contains(said), "{rest}\n{refused}");
    }
    assert!(
        refusal("DIMENSION: 3\nEDGE_WEIGHT_TYPE: GEO\nNODE_COORD_SECTION\n1 0 0\n2 91 0\n3 0 0\n")
            .contains("no place on the globe")
    );
}

#[test]
fn tours_visit_every_place_once_and_begin_with_the_first() {
    let problem = read(&format!("{FLAT}1 0 0\n2 1 1\n3 3 3\nEOF\n")).unwrap();
    let tour = |text: &str| read_tour(text.as_bytes(), &problem);
    assert_eq!(tour("TYPE: TOUR\nDIMENSION: 3\nTOUR_SECTION\n3 1\n2\n-1\nEOF\n-1\nEOF\n"), Ok(vec![0, 1]));
    for (text, said) in [
        ("TYPE: TOUR\nTOUR_SECTION\n1 2 2\n-1\n", "place 2 a second time"),
        ("TYPE: TOUR\nTOUR_SECTION\n1 2\n-1\n", "leaves out place 3"),
        ("TYPE: TOUR\nTOUR_SECTION\n1 2 4\n-1\n", "`4` is no place"),
        ("TYPE: TOUR\nTOUR_SECTION\n1 2 3 -1 3 2 1 -1\n", "a second tour"),
        ("TYPE: TOUR\nDIMENSION: 4\nTOUR_SECTION\n1 2 3 -1\n", "DIMENSION: is 4"),
        ("TYPE: TOUR\nTOUR_SECTION\n1 2 3 -1\nEOF\n5\n", "stands behind EOF"),
        ("TYPE: TOUR\n", "TOUR_SECTION: is missing"),
        ("TYPE: TSP\nDIMENSION: 3\n", "TYPE: is not TOUR"),
    ] {
        let refused = tour(text).unwrap_err().to_string();
        assert!(refused.contains(said), "{text}\n{refused}");
    }
}
