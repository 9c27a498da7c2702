//! A reader of TSPLIB 95 files with coordinates (Reinelt 1991): EUC_2D, ATT and GEO, and tours.

use formicarium::exact::order::Costs;

/// A problem of the library.
pub struct Problem {
    pub name: String,
    kind: String,
    at: Vec<[f64; 2]>,
}

impl Problem {
    /// Reads a `.tsp` file.
    pub fn read(text: &str) -> Self {
        let field =
            |key: &str| text.lines().find_map(|l| Some(l.strip_prefix(key)?.trim_start_matches([' ', ':']).trim().to_string()));
        let at = section(text, "NODE_COORD_SECTION")
            .map(|line| {
                let numbers: Vec<f64> = line.split_whitespace().map(|w| w.parse().expect("a number")).collect();
                [numbers[1], numbers[2]]
            })
            .collect();
        Self { name: field("NAME").expect("a name"), kind: field("EDGE_WEIGHT_TYPE").expect("a kind"), at }
    }

    /// From GEO coordinates.
    pub fn geo(name: &str, at: &[[f64; 2]]) -> Self {
        Self { name: name.into(), kind: "GEO".into(), at: at.to_vec() }
    }

    /// Distances between all nodes; the first is the start.
    pub fn costs(&self) -> Costs {
        let distance = match self.kind.as_str() {
            "EUC_2D" => euclidean,
            "ATT" => pseudo_euclidean,
            "GEO" => geographical,
            other => panic!("{other} is not read"),
        };
        Costs::new(self.at.len(), |i, j| distance(self.at[i], self.at[j]))
    }
}

/// The nodes of a `.tour` file from 0, turned so that it begins with the first: an order of the others.
pub fn read_tour(text: &str) -> Vec<u32> {
    let words: Vec<&str> = section(text, "TOUR_SECTION").flat_map(str::split_whitespace).collect();
    let mut nodes: Vec<u32> = words.iter().map_while(|w| w.parse::<u32>().ok()).collect();
    let first = nodes.iter().position(|&n| n == 1).expect("node 1");
    nodes.rotate_left(first);
    nodes[1..].iter().map(|n| n - 2).collect()
}

fn section<'a>(text: &'a str, name: &str) -> impl Iterator<Item = &'a str> {
    let begins = text.find(name).expect("the section") + name.len();
    text[begins..].lines().skip(1).map(str::trim).take_while(|l| !l.is_empty() && *l != "EOF" && *l != "-1")
}

/// nint of the format: (int) (x + 0.5).
fn nint(x: f64) -> f64 {
    (x + 0.5).trunc()
}

fn euclidean(a: [f64; 2], b: [f64; 2]) -> f64 {
    nint((a[0] - b[0]).hypot(a[1] - b[1]))
}

/// ATT: rounded up from √(d² / 10).
fn pseudo_euclidean(a: [f64; 2], b: [f64; 2]) -> f64 {
    let r = (((a[0] - b[0]).powi(2) + (a[1] - b[1]).powi(2)) / 10.0).sqrt();
    let t = nint(r);
    if t < r { t + 1.0 } else { t }
}

/// GEO: degrees and minutes on a sphere, in kilometres. The listed optima hold for degrees cut off, not rounded as the format's text says.
fn geographical(a: [f64; 2], b: [f64; 2]) -> f64 {
    #[expect(clippy::approx_constant, reason = "the format's own")]
    const PI: f64 = 3.141592;
    const RADIUS: f64 = 6378.388;
    let radians = |x: f64| PI * (x.trunc() + 5.0 * (x - x.trunc()) / 3.0) / 180.0;
    let ([lat_a, lon_a], [lat_b, lon_b]) = (a.map(radians), b.map(radians));
    let (q1, q2, q3) = ((lon_a - lon_b).cos(), (lat_a - lat_b).cos(), (lat_a + lat_b).cos());
    (RADIUS * (0.5 * ((1.0 + q1) * q2 - (1.0 - q1) * q3)).acos() + 1.0).trunc()
}
