//! Scenes: that each starts from what the paper says, and that a short run of it does what is known of it.

mod gresho_chan;
mod noh;
mod sedov;
mod support;
