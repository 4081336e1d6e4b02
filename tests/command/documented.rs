//! Whether JSON is what its page in `docs/` says: no key more, none less, each of its type.
//!
//! A page has a section for each object, under its path between backticks (`` ## `runs[].stages[]` ``; `## Top level` for the
//! whole), with a table whose first column names keys and whose second their type.

use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};

struct Key {
    name: String,
    kind: String,
    optional: bool,
    meaning: String,
}

/// A page: the keys of each object, by the object's path.
pub struct Page {
    name: String,
    objects: BTreeMap<String, Vec<Key>>,
    seen: BTreeSet<String>,
}

impl Page {
    /// Reads `docs/NAME`.
    pub fn read(name: &str) -> Self {
        let text = std::fs::read_to_string(format!("{}/docs/{name}", env!("CARGO_MANIFEST_DIR"))).unwrap();
        let mut objects = BTreeMap::<String, Vec<Key>>::new();
        let mut place = None;
        for line in text.lines() {
            if let Some(heading) = line.strip_prefix("## ") {
                place = match heading {
                    "Top level" => Some(String::new()),
                    _ => heading.strip_prefix('`').and_then(|path| path.strip_suffix('`')).map(String::from),
                };
            }
            let cells: Vec<&str> = line.trim_matches('|').split('|').map(str::trim).collect();
            if let (Some(place), true) = (&place, line.starts_with("| `")) {
                let (kind, optional) = match cells[1].strip_suffix(", optional") {
                    Some(kind) => (kind, true),
                    None => (cells[1], false),
                };
                // `a`, `b`: what is between backticks stands at odd places.
                objects.entry(place.clone()).or_default().extend(cells[0].split('`').skip(1).step_by(2).map(|name| {
                    let meaning = cells[cells.len() - 1].to_string();
                    Key { name: name.into(), kind: kind.into(), optional, meaning }
                }));
            }
        }
        Page { name: name.into(), objects, seen: BTreeSet::new() }
    }

    /// Compares output with the page.
    pub fn check(&mut self, output: &Value) {
        let seen = self.object("", output);
        self.seen.extend(seen);
        for key in self.objects[""].iter().filter(|key| key.name.starts_with("schema")) {
            let value = output[&key.name].to_string().replace('"', "");
            assert!(key.meaning.contains(&format!("`{value}`")), "{}: {} is {value} by now", self.name, key.name);
        }
    }

    /// Fails if the page has keys that no output had.
    pub fn all_seen(&self) {
        for (place, keys) in &self.objects {
            for key in keys {
                let path = join(place, &key.name);
                assert!(self.seen.contains(&path), "{} describes `{path}`, which is nowhere", self.name);
            }
        }
    }

    /// The paths of all keys below.
    fn object(&self, place: &str, value: &Value) -> Vec<String> {
        let name = &self.name;
        let keys = self.objects.get(place).unwrap_or_else(|| panic!("{name} has no section `{place}`"));
        let object = value.as_object().unwrap_or_else(|| panic!("`{place}` is no object: {value}"));
        for found in object.keys() {
            assert!(keys.iter().any(|key| key.name == *found), "{name} says nothing of `{}`", join(place, found));
        }
        let mut seen = Vec::new();
        for key in keys {
            let path = join(place, &key.name);
            match object.get(&key.name) {
                Some(value) => seen.extend(self.value(&path, &key.kind, value)),
                None => assert!(key.optional, "`{path}` is missing, which {name} describes"),
            }
        }
        seen
    }

    fn value(&self, path: &str, kind: &str, value: &Value) -> Vec<String> {
        let every = |is: fn(&Value) -> bool| value.as_array().is_some_and(|all| all.iter().all(is));
        let both = |is: fn(&Value) -> bool| {
            value.as_object().is_some_and(|of| of.len() == 2 && ["f32", "f64"].iter().all(|p| is(&value[p])))
        };
        let mut seen = vec![path.to_string()];
        let fits = match kind {
            "string" => value.is_string(),
            "boolean" => value.is_boolean(),
            "integer" => value.is_u64(),
            "number" => value.is_number(),
            "list of strings" => every(Value::is_string),
            "list of integers" => every(Value::is_u64),
            "list of numbers" => every(Value::is_number),
            "integers by precision" => both(Value::is_u64),
            "numbers by precision" => both(Value::is_number),
            "object" => {
                seen.extend(self.object(path, value));
                true
            }
            "list" => value.as_array().is_some_and(|all| {
                seen.extend(all.iter().flat_map(|value| self.object(&format!("{path}[]"), value)));
                !all.is_empty()
            }),
            _ => panic!("{}: `{path}` is of an unknown type, {kind}", self.name),
        };
        assert!(fits, "`{path}` is no {kind}: {value}");
        seen
    }
}

fn join(place: &str, name: &str) -> String {
    if place.is_empty() { name.to_string() } else { format!("{place}.{name}") }
}
