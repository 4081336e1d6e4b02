//! The `#[equation]` macro as its users meet it: what equations do, and what is registered. What is refused is tested beside
//! the macro crate.
#![forbid(unsafe_code)]

#[path = "equation_macro/behaviour.rs"]
mod behaviour;
#[path = "equation_macro/equations.rs"]
mod equations;
#[path = "equation_macro/pair.rs"]
mod pair;
#[path = "equation_macro/registry.rs"]
mod registry;
