//! The program as users run it: what it prints, what it leaves, how it refuses.

mod compare;
mod documented;
mod equations;
mod interrupted;
mod kernels;
mod place;
mod refusals;
mod runs;
mod scenes;
mod sweeps;

use place::{Place, code, stderr, stdout};

/// The smallest tube that is one: a second even without optimisation.
const TINY: [&str; 6] = ["run", "sod", "--dim", "1", "--n", "100"];

fn tiny<'a>(more: &[&'a str]) -> Vec<&'a str> {
    [&TINY[..], more].concat()
}

/// Bad input: exit code 2, these words in one line on stderr, nothing on stdout, nothing written.
fn refused(test: &str, arguments: &[&str], words: &[&str]) {
    let place = Place::new(test);
    let output = place.etalon(arguments);
    let message = stderr(&output);
    assert_eq!(code(&output), Some(2), "{arguments:?}: {message}");
    assert_eq!(message.lines().count(), 1, "{arguments:?}: {message}");
    for word in words {
        assert!(message.contains(word), "{arguments:?}: `{word}` is missing in: {message}");
    }
    assert_eq!(stdout(&output), "", "{arguments:?}");
    assert_eq!(place.listing(), Vec::<String>::new(), "{arguments:?}");
}
