//! Many runs, one after the other, each remembered as soon as it is done, so that an interruption costs some minutes of one run at most.
//!
//! | file | what lives there |
//! |---|---|
//! | `job.rs` | one run: a scene with all choices, a backend, a precision; what is remembered of it |
//! | `make.rs` | many of them, as the commands ask for it |
//! | `store.rs` | the file of what is done |
//! | `work.rs` | what is left to do, how long it will take, doing it |

mod job;
mod make;
mod store;
mod work;

pub use job::{Job, Record};
pub use make::{Made, make};
pub use store::Store;
pub use work::done_of;
