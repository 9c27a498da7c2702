use super::*;

fn numbers_of(text: &str) -> Vec<Vec<f32>> {
    let found = read(text, None).unwrap_or_else(|e| panic!("{text:?}: {e}"));
    found.table.rows().map(|row| row.iter().collect()).collect()
}

fn refusal(text: &str) -> String {
    match find(text) {
        Err(error) => error.to_string(),
        Ok(found) => panic!("{text:?} gave {}", list(&found)),
    }
}

fn notice_kinds(text: &str) -> Vec<String> {
    read(text, None).unwrap().notices.iter().map(|n| n.kind.clone()).collect()
}

#[test]
fn every_spelling_of_one_table() {
    let spellings = [
        "0,0,1\n0,1,0\n",
        "0 0 1\r\n0 1 0",
        "0\t0\t1\t\n0\t1\t0\t\n\n",
        "0;0;1\n0;1;0\n",
        "0 0 1; 0 1 0",
        "0,0,1;\n0,1,0;\n",
        "001\n010\n",
        "G = [0 0 1; 0 1 0];",
        "G=[0 0 1;...\n 0 1 0;];\n",
        "G = [0 0 ... the first row\n 1\n 0 1 0];",
        "% map\nmap = [ 0, 0, 1 % top\n 0, 1, 0 ];\n[r,c] = size(map);",
        "[[0, 0, 1], [0, 1, 0]]",
        "[0, 0, 1]\n[0, 1, 0]\n",
        "grid = np.array([[0, 0,\n 1],\n [0, 1, 0]], dtype=int)",
        "[[0 0 1]\n [0 1 0]]",
        "G =\n\n     0     0     1\n     0     1     0\n",
        "\"0\",\"0\",\"1\"\n\"0\",\"1\",\"0\"\n",
        "# header\n0.0 0.0 1.0\n0.0 1.0 0.0",
        "0 0 1\n\n0 1 0\n",
        "int g[2][3] = {{0, 0, 1}, {0, 1, 0}};",
        "const g = [[0, 0, 1], [0, 1, 0]]; g[0][1] = 0;",
        "int[][] g = new int[][] {\n {0, 0, 1}, // top\n {0, 1, 0},\n};",
        "{{0, 0, 1}, {0, 1, 0}}",
        "def grid():\n    return [[0, 0, 1],\n            [0, 1, 0]]\n",
        "2 3\n0 0 1\n0 1 0\n",
        "3 2\n\n0 0 1\n0 1 0\n",
        "a,b,c\n0,0,1\n0,1,0\n",
        "\"\",\"V1\",\"V2\",\"V3\"\n\"1\",0,0,1\n\"2\",0,1,0\n",
        "V1 V2 V3\nr1 0 0 1\nr2 0 1 0\n",
        "  Columns 1 through 2\n\n     0     0\n     0     1\n\n  Column 3\n\n     1\n     0\n",
        "G =\n\n  列 1 至 2\n\n   0   0\n   0   1\n\n  列 3\n\n   1\n   0\n",
    ];
    for text in spellings {
        assert!(looks_like(text).is_some(), "{text:?}");
        assert_eq!(numbers_of(text), [[0.0, 0.0, 1.0], [0.0, 1.0, 0.0]], "{text:?}");
    }
}

#[test]
fn what_is_left_out_is_told() {
    for (text, kind) in [
        ("2 3\n0 0 1\n0 1 0\n", "matrix-size-line"),
        ("a,b,c\n0,0,1\n0,1,0\n", "matrix-labels"),
        ("  Columns 1 through 2\n\n 0 0\n 0 1\n\n  Column 3\n\n 1\n 0\n", "matrix-columns-joined"),
    ] {
        assert_eq!(notice_kinds(text), [kind], "{text:?}");
    }
}

#[test]
fn labels_that_count_are_no_cells() {
    let body = [[0.0, 0.0, 1.0, 1.0], [0.0, 1.0, 0.0, 0.0], [1.0, 0.0, 0.0, 0.0]];
    for text in [
        "0,1,2,3\n0,0,1,1\n0,1,0,0\n1,0,0,0\n",
        "1,2,3,4\n0,0,1,1\n0,1,0,0\n1,0,0,0\n",
        ",0,1,2,3\n0,0,0,1,1\n1,0,1,0,0\n2,1,0,0,0\n",
        "x,0,1,2,3\n0,0,0,1,1\n1,0,1,0,0\n2,1,0,0,0\n",
        "y\\x;1;2;3;4\n1;0;0;1;1\n2;0;1;0;0\n3;1;0;0;0\n",
        ",a,b,c,d\n0,0,0,1,1\n1,0,1,0,0\n2,1,0,0,0\n",
        "\t0\t1\t2\t3\n0\t0\t0\t1\t1\n1\t0\t1\t0\t0\n2\t1\t0\t0\t0\n",
    ] {
        assert_eq!(numbers_of(text), body, "{text:?}");
        assert_eq!(notice_kinds(text), ["matrix-labels"], "{text:?}");
    }
    // A column of labels alone has to count to three at least.
    assert_eq!(numbers_of("0,0,1\n1,0,0\n2,1,0\n3,0,0\n"), [[0.0, 1.0], [0.0, 0.0], [1.0, 0.0], [0.0, 0.0]]);
    // A slope is no label, nor are a free cell, a wall, the start and the goal.
    assert_eq!(numbers_of("0,1,2,3\n1,2,3,4\n2,3,4,5\n").len(), 3);
    assert_eq!(numbers_of("0,1,2,3\n3,2,1,0\n").len(), 2);
    assert!(refusal("x,1,2,3\n0,0,1,0\n0,0,0,1\n").contains("column 1"));
    assert!(refusal("0,1,2\n0,0,1\n0,1,0\n0,0,0\n").contains("labels"));
}

#[test]
fn a_program_gives_its_matrix_and_nothing_else() {
    let programs = [
        "#define ROW 4\nint main() {\n  /* 1 = free */\n  int grid[ROW][COL] = {\n    {1, 1, 0},\n    {1, 0, 1}\n  };\n  int dx[8] = {0,1,0,-1,1,1,-1,-1};\n  return grid[0][0];\n}\n",
        "%{\nG=[0 0 0 0;\n 0 1 1 0];\n%}\nG=[1 1 0;\n 1 0 1];\nS=[1 1]; E=[2 3]; disp(G(1,2)); d=[0 1;1 0;0 -1;-1 0];\n",
        "\"\"\"\nmaze = [[9, 9], [9, 9]]\n\"\"\"\nmaze = [[1, 1, 0],\n        [1, 0, 1]]\nmoves = [(0, 1), (1, 0)]\nprint(maze[0][1])\n",
        "public class A { static int[][] g = {{1,1,0},{1,0,1}}; int[] d = {0,1}; }",
    ];
    for text in programs {
        assert_eq!(numbers_of(text), [[1.0, 1.0, 0.0], [1.0, 0.0, 1.0]], "{text}");
        assert!(read(text, None).unwrap().table.has_rest, "{text}");
    }
}

#[test]
fn several_matrices_are_told_apart() {
    let program = "G=[0 0 0 0;\n 0 1 1 0;\n 0 0 0 0];\nG=[0 0 0 1;\n 0 0 0 1;\n 0 1 0 0];\nS=1;\n";
    let plain = "0 0 0 1\n0 1 0 0\n\n0 0 1 1\n1 0 0 0\n";
    let titled = "A =\n\n 0 1\n 1 0\n\nB =\n\n 0 0\n 1 0\n";
    for text in [program, plain, titled] {
        assert!(matches!(read(text, None), Err(FormatError::Several { .. })), "{text}");
        let second = read(text, Some(2)).unwrap();
        assert_eq!(second.notices[0].kind, "matrix-chosen");
        assert!(read(text, Some(3)).is_err() && read(text, Some(0)).is_err());
    }
    assert_eq!(read(titled, Some(2)).unwrap().name, "B");
    // The same map twice is one.
    assert_eq!(find("a = [0 1; 1 0];\nb = [0 1; 1 0];\n").unwrap().len(), 1);
}

#[test]
fn what_stands_there_more_than_once_is_told_and_never_cut_off() {
    let many = |times: usize| "0 0 1\n0 1 0\n\n".repeat(times);
    assert_eq!(notice_kinds(&many(1)), [] as [&str; 0]);
    assert_eq!(notice_kinds(&many(3)), ["matrix-repeated"]);
    assert_eq!(find(&many(1000)).unwrap().len(), 1);
    assert!(refusal(&(many(1000) + "1 1 1\n0 0 0\n")).contains("1001 matrices"));
}

#[test]
fn sizes_and_ends_above_the_rows() {
    let found = read("3 4\n0 0\n3 2\n0 0 1 0\n0 0 0 0\n1 0 0 0\n", None).unwrap();
    assert_eq!(found.ends, Some(Ends { start: [0, 0], goal: [3, 2] }));
    assert_eq!(found.table.height(), 3);
    assert!(refusal_of_size("3 5\n0 0 1 0\n0 0 0 0\n1 0 0 0\n").contains("row 2"));
}

fn refusal_of_size(text: &str) -> String {
    read(text, None).unwrap().table.size().unwrap_err().to_string()
}

#[test]
fn an_empty_field_is_never_skipped() {
    for (text, place) in
        [("0,,1\n0,1,0\n", "line 1: column 2"), (",0,1\n0,1,0\n", "line 1: column 1"), ("0;0\n;1\n", "line 2: column 1")]
    {
        assert!(refusal(text).contains(place), "{}", refusal(text));
    }
    assert!(refusal("G = [0,,1; 0,1,0]").contains("column 2"));
    assert!(refusal_of_size("0,0,0\n0,0,\n").contains("row 2"));
}

#[test]
fn what_is_no_number_is_quoted_with_its_line() {
    for (text, line, what) in [("0 1\n0 x\n", 2, "`x`"), ("G = [0 1;\n 1 nan]", 2, "`nan`"), ("\nG = [0 1", 2, "`[`")] {
        let Err(FormatError::Syntax { line: got, what: said, .. }) = find(text) else { panic!("{text:?}") };
        assert_eq!(got, line, "{text:?}");
        assert!(said.contains(what), "{said}");
    }
}

#[test]
fn millions_of_short_rows_are_refused_at_once() {
    let text = "0\n".repeat(3 << 20);
    assert!(matches!(find(&text), Err(FormatError::TooLarge { .. })));
    assert!(matches!(find(&"0 ".repeat(20 << 20)), Err(FormatError::TooLarge { .. })));
}

#[test]
fn what_was_left_out_or_cannot_be_read_is_refused() {
    for (text, told) in [
        ("[[0 0 1]\n [0 1 0]\n ...\n [0 1 0]]\n", "line 3: numbers were left out"),
        ("array([[0, 0],\n       ...,\n       [0, 1]])", "numbers were left out"),
        ("0,1,...,0\n0,0,...,1\n1,0,...,0\n", "line 1: numbers were left out"),
        ("0,0,...\n0,1,...\n", "line 1: numbers were left out"),
        ("0,0,1,#N/A\n0,1,0,#N/A\n", "`#N/A` is no number"),
        ("[[[0 0 1]\n [0 1 0]]\n\n [[0 0 0]\n [1 1 0]]]\n", "three dimensions"),
        ("[[0,0,null,1],[0,1,0,0]]", "`null` is no number"),
        ("[[0,0,1],[],[0,1,0]]", "a row is empty"),
        ("Columns 1 through 3\n\n 0 0 1\n 0 1 0\n\nColumns 7 through 9\n\n 0 1 1\n 1 1 0\n", "columns 7 to 9"),
        ("Columns 4 through 6\n\n 0 0 1\n 0 1 0\n", "columns 4 to 6"),
        ("Columns 1 through 4294967295\n\n 0 0 1\n 0 1 0\n", "columns 1 to 4294967295"),
    ] {
        let error = read(text, None).map(|_| ()).unwrap_err().to_string();
        assert!(error.contains(told), "{text:?}: {error}");
    }
}

#[test]
fn what_stands_above_a_printed_matrix_is_no_row() {
    for text in ["G =\n\n  2×3 logical array\n\n   0   0   1\n   0   1   0\n", "2×3 Matrix{Int64}:\n 0  0  1\n 0  1  0\n"] {
        let found = read(text, None).unwrap();
        assert_eq!((found.table.height(), found.table.row(0).len()), (2, 3), "{text:?}");
    }
}

#[test]
fn matrices_within_texts_of_a_program_are_none() {
    for text in ["s = \"[[0,0,1],[0,1,0]]\"\n", "const r = /[[0,1],[1,0]]/\n", "disp('[0 0 1; 0 1 0]')\n"] {
        assert_eq!(looks_like(text), None, "{text:?}");
    }
}
