//! A folder of one test alone, and the program run in it.
// Not every test asks for all of it.
#![allow(dead_code)]

use serde_json::Value;
use std::fs;
use std::path::PathBuf;
use std::process::{Command, Output};

/// A folder of one test alone, removed at its end.
pub struct Place(PathBuf);

impl Place {
    pub fn new(test: &str) -> Self {
        let path = std::env::temp_dir().join(format!("etalon-command-{test}-{}", std::process::id()));
        let _ = fs::remove_dir_all(&path);
        fs::create_dir_all(&path).unwrap();
        Place(path)
    }
    pub fn path(&self, name: &str) -> PathBuf {
        self.0.join(name)
    }
    /// Runs the program here, as on a machine without any graphics driver.
    pub fn etalon(&self, arguments: &[&str]) -> Output {
        Command::new(env!("CARGO_BIN_EXE_etalon"))
            .args(arguments)
            .current_dir(&self.0)
            .env("VK_DRIVER_FILES", "/dev/null")
            .env("VK_ICD_FILENAMES", "/dev/null")
            .env_remove("ETALON_ADAPTER")
            .output()
            .unwrap()
    }
    /// Runs the program here, with the graphics drivers there are.
    pub fn etalon_with_drivers(&self, arguments: &[&str]) -> Output {
        Command::new(env!("CARGO_BIN_EXE_etalon")).args(arguments).current_dir(&self.0).output().unwrap()
    }
    pub fn listing(&self) -> Vec<String> {
        let entries = fs::read_dir(&self.0).unwrap();
        let mut names: Vec<String> = entries.map(|e| e.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }
}

impl Drop for Place {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

pub fn stdout(output: &Output) -> &str {
    std::str::from_utf8(&output.stdout).unwrap()
}

pub fn stderr(output: &Output) -> &str {
    std::str::from_utf8(&output.stderr).unwrap()
}

pub fn code(output: &Output) -> Option<i32> {
    output.status.code()
}

pub fn json(text: &str) -> Value {
    serde_json::from_str(text).unwrap_or_else(|error| panic!("{error} in {text}"))
}
