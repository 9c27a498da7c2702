//! A comparison that is compared again in its own folder: the file is the evidence, and is replaced only by results that say the same.

use std::path::PathBuf;

use super::args::Args;
use super::place::{Place, is_same};

/// The file that is compared, where the results would replace it.
pub struct Held(Option<PathBuf>);

impl Held {
    /// What the arguments would replace.
    pub fn of(args: &Args) -> Self {
        let results = args.place().file("json");
        Self(args.question.clone().filter(|input| args.ablate.is_none() && is_same(input, &results)))
    }

    /// Where results may go in the end.
    pub fn places(&self, place: &Place) -> Vec<Place> {
        let again = self.0.is_some().then(|| place.again());
        [place.clone()].into_iter().chain(again).collect()
    }

    /// Where they go, and what is to be said about it; `stands`: they have all that the file has.
    pub fn choose(&self, place: Place, stands: bool) -> (Place, String) {
        match &self.0 {
            Some(input) if !stands => {
                let (input, again) = (input.display(), place.again());
                let names = again.file("*");
                let said =
                    format!("{input} and what is beside it stay as they are, because not all of its runs came out again: ");
                (again, said + &format!("the new results are in {}\n", names.display()))
            }
            _ => (place, String::new()),
        }
    }
}
