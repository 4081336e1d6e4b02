//! The device that the tests of a program share.

use std::io::Write;
use std::sync::OnceLock;

use etalon_wgpu::{AdapterPreference, Device};

/// The device, opened once for all tests; `None`, said aloud, where there is no adapter.
pub fn device() -> Option<&'static Device> {
    static DEVICE: OnceLock<Option<Device>> = OnceLock::new();
    let device = DEVICE.get_or_init(|| match Device::open(AdapterPreference::from_environment()) {
        Ok(device) => {
            say(&format!("adapter: {}", device.adapter()));
            Some(device)
        }
        Err(error) => {
            let required = std::env::var("ETALON_REQUIRE_ADAPTER").is_ok_and(|value| value != "0");
            assert!(!required, "ETALON_REQUIRE_ADAPTER is set, but {error}");
            None
        }
    });
    if device.is_none() {
        say("SKIPPED: no adapter");
    }
    device.as_ref()
}

/// Straight to the terminal: what the test harness captures of a test that passes is never seen.
fn say(line: &str) {
    // Nothing is lost if nobody listens.
    let _ = writeln!(std::io::stderr(), "{line}");
}
