//! Drawing, simplifying, counting, linting and printing.

mod c;
mod drawing;
mod lint;
mod passes;
mod programs;
mod random;
mod toys;
mod wgsl;
