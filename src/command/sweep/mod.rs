//! Many runs, one after the other, each remembered as soon as it is done, so that an interruption costs one run at most.
//!
//! | file | what lives there |
//! |---|---|
//! | `job.rs` | one run: a scene with all choices, a backend, a precision; what is remembered of it |
//! | `store.rs` | the file of what is done |
//! | `work.rs` | what is left to do, how long it will take, doing it |

mod job;
mod store;
mod work;

pub use job::{Job, Record};
pub use store::Store;
pub use work::{Chances, done_of, work};
