//! The audit of the equations, on small samples. `etalon audit` takes large ones.

#[path = "audit/bad_input.rs"]
mod bad_input;
#[path = "audit/budgets.rs"]
mod budgets;
#[path = "audit/declarations.rs"]
mod declarations;
#[path = "audit/derivatives.rs"]
mod derivatives;
#[path = "audit/device.rs"]
mod device;
#[path = "audit/enclosures.rs"]
mod enclosures;
#[path = "audit/formula.rs"]
mod formula;
#[path = "audit/oracle.rs"]
mod oracle;
#[path = "audit/pages.rs"]
mod pages;
#[path = "audit/state.rs"]
mod state;
#[path = "audit/textbook.rs"]
mod textbook;
#[path = "audit/units.rs"]
mod units;
