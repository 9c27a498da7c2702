//! `page`: a session or comparison as a page of one file.
use super::folder::Folder;

const VERSION: &str = env!("CARGO_PKG_VERSION");
const SESSION: &str = include_str!("../fixtures/links/0.1.0/session.experiment.json");
const LINK: &str = include_str!("../fixtures/links/0.1.0/session.link");
const COMPARISON: &str = include_str!("../fixtures/links/0.1.0/study.result.json");

const BEFORE: &str = "<script type=\"application/json\" id=\"carried\" data-format=\"formicarium/page@1\" data-from=\"";

/// What a page looks like around its program.
fn template(version: &str, from: &str, carried: &str) -> String {
    format!(
        "<!DOCTYPE html>\n<html><head><meta name=\"generator\" content=\"Formicarium {version}\">\n<title>Formicarium</title></head>\n\
         <body>{BEFORE}{from}\">{carried}</script>\n<script id=\"packed\">AAAA</script></body></html>"
    )
}

fn folder(test: &str) -> Folder {
    let folder = Folder::with_map(test);
    folder.write("template.html", &template(VERSION, "", ""));
    folder.write("race.experiment.json", SESSION);
    folder.write("mail.txt", &format!("Look at this: {}\n\nAda", LINK.trim()));
    folder.write("study.result.json", COMPARISON);
    folder
}

/// What stands in the element.
fn carried(page: &str) -> &str {
    let (_, rest) = page.split_once(BEFORE).unwrap();
    rest.split_once("\">").unwrap().1.split_once("</script>").unwrap().0
}

#[test]
fn a_session_and_a_comparison_are_carried_as_they_are() {
    let folder = folder("page");
    for (file, text) in [("race.experiment.json", SESSION), ("study.result.json", COMPARISON)] {
        let page = folder.run(&["page", file, "--page", "template.html"]).ends(0).out;
        assert_eq!(carried(&page).replace("\\u003c", "<"), text.trim());
        assert!(page.contains(" · Formicarium</title>"), "{page}");
        assert!(page.ends_with("<script id=\"packed\">AAAA</script></body></html>"));
        folder.run(&["page", file, "--page", "template.html", "--out", "page.html"]).ends(0);
        assert_eq!(folder.read("page.html"), page);
        // A page is a template in its turn.
        assert_eq!(folder.run(&["page", file, "--page", "page.html"]).ends(0).out, page);
    }
}

#[test]
fn a_link_is_taken_out_of_its_text() {
    let folder = folder("page-link");
    let page = folder.run(&["page", "mail.txt", "--page", "template.html"]).ends(0).out;
    let (_, sealed) = LINK.trim().split_once("#x=").unwrap();
    assert_eq!(carried(&page), format!("\"#x={sealed}\""));
}

#[test]
fn no_text_ends_the_element_and_the_address_stays() {
    let folder = folder("page-escaped");
    let named = SESSION.replacen('{', r#"{ "title": "a </script> & <b>","#, 1);
    folder.write("named.json", &named);
    let address = "https://example.org/f?a=1&amp;b=2";
    folder.write("saved.html", &template(VERSION, address, "{}"));
    let page = folder.run(&["page", "named.json", "--page", "saved.html"]).ends(0).out;
    assert!(page.contains("<title>a &lt;/script&gt; &amp; &lt;b&gt; · Formicarium</title>"), "{page}");
    assert_eq!(carried(&page).replace("\\u003c", "<"), named.trim());
    assert!(page.contains(&format!("data-from=\"{address}\"")));
}

#[test]
fn other_versions_are_told() {
    let folder = folder("page-versions");
    let quiet = folder.run(&["page", "race.experiment.json", "--page", "template.html"]).ends(0);
    assert_eq!(quiet.err, "");
    folder.write("old.html", &template("0.0.9", "", ""));
    folder
        .run(&["page", "race.experiment.json", "--page", "old.html", "--out", "page.html"])
        .ends(0)
        .says(&["the page runs engine 0.0.9, this command line is", "were recorded by"]);
}

#[test]
fn what_cannot_be_carried_is_refused_by_name() {
    let folder = folder("page-refused");
    let with = |file| folder.run(&["page", file, "--page", "template.html"]).ends(2);
    with("small.map").says(&["small.map", "a map of the MovingAI benchmarks", "a session or comparison as the page saves it"]);
    folder.write("damaged.json", &SESSION.replacen("\"seed\"", "\"sed\"", 1));
    with("damaged.json").says(&["damaged.json", "`seed` is missing"]);
    folder.write("cut.txt", &LINK.trim()[..LINK.find("#x=").unwrap() + 60]);
    with("cut.txt").says(&["cut.txt", "damaged"]);
}

#[test]
fn without_a_template_it_says_how_to_get_one() {
    let folder = folder("page-template");
    folder.run(&["page", "race.experiment.json"]).ends(2).says(&[
        "there is no one-file.html",
        "Save as a page",
        "FORMICARIUM_PAGE",
    ]);
    folder.run(&["page", "race.experiment.json", "--page", "mail.txt"]).ends(2).says(&["mail.txt is no page of one file"]);
    std::fs::create_dir_all(folder.0.join("www/dist")).unwrap();
    folder.write("www/dist/one-file.html", &template(VERSION, "", ""));
    folder.run(&["page", "race.experiment.json"]).ends(0).says(&["\"formicarium/experiment@1\""]);
}
