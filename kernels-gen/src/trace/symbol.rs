//! The number that remembers what is done to it.
//!
//! A symbol is an index into the graph under construction, of which there is at most one per thread. Symbols are plain
//! copies and can outlive their drawing; using one elsewhere is found and reported, not followed.

use super::drawing::{Drawing, Output};
use super::error::TraceError;
use super::graph::{Graph, Id, Literal, Op, Scope};
use crate::real::{Choose, Mask, Nameable, Precision, Real};
use std::cell::RefCell;
use std::fmt::Debug;
use std::marker::PhantomData;
use std::ops::{Add, Div, Mul, Neg, Sub};
use std::sync::atomic::{AtomicU64, Ordering};

/// The precision that a drawing is made for: [`Single`] or [`Double`].
pub trait Significand: Copy + Debug + PartialEq + 'static {
    /// The coefficient set that equations choose.
    const PRECISION: Precision;
    /// A constant as this precision holds it.
    fn round(value: f64) -> f64;
}

/// 24 bits of significand: for `f32` and WGSL.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Single;
/// 53 bits of significand: for `f64`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Double;

impl Significand for Single {
    const PRECISION: Precision = Precision::Single;
    fn round(value: f64) -> f64 {
        value as f32 as f64
    }
}
impl Significand for Double {
    const PRECISION: Precision = Precision::Double;
    fn round(value: f64) -> f64 {
        value
    }
}

/// A real number of a drawing. Outside of [`draw`] it computes nothing and stands for nothing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Symbol<P> {
    place: Place,
    precision: PhantomData<P>,
}

/// A mask of a drawing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SymbolMask(Place);

/// A node, and which drawing it is of.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Place {
    id: Option<Id>,
    drawing: u64,
}

/// The graph under construction.
struct Sheet {
    drawing: u64,
    graph: Graph,
    scopes: Vec<Scope>,
    foreign: bool,
}

thread_local! {
    static SHEET: RefCell<Option<Sheet>> = const { RefCell::new(None) };
}
// Numbers are never given twice, so that a symbol is recognised on any thread and at any time; 0 is no drawing.
static NEXT_DRAWING: AtomicU64 = AtomicU64::new(1);

/// Puts an operation on this thread's sheet. Every operand must be of that sheet.
fn record<const N: usize>(operands: [Place; N], op: impl FnOnce([Id; N]) -> Op) -> Place {
    const NOWHERE: Place = Place { id: None, drawing: 0 };
    SHEET.with_borrow_mut(|sheet| {
        let Some(sheet) = sheet else { return NOWHERE };
        let mut ids = Vec::with_capacity(N);
        for place in operands {
            match place.id {
                Some(id) if place.drawing == sheet.drawing => ids.push(id),
                _ => sheet.foreign = true,
            }
        }
        let Ok(ids) = <[Id; N]>::try_from(ids) else { return NOWHERE };
        let id = sheet.graph.add(op(ids), sheet.scopes.last().copied());
        Place { id: Some(id), drawing: sheet.drawing }
    })
}

impl<P> Symbol<P> {
    fn at(place: Place) -> Self {
        Symbol { place, precision: PhantomData }
    }
    fn unary(self, op: impl FnOnce(Id) -> Op) -> Self {
        Self::at(record([self.place], |[a]| op(a)))
    }
    fn binary(self, other: Self, op: impl FnOnce(Id, Id) -> Op) -> Self {
        Self::at(record([self.place, other.place], |[a, b]| op(a, b)))
    }
    fn compare(self, other: Self, op: impl FnOnce(Id, Id) -> Op) -> SymbolMask {
        SymbolMask(record([self.place, other.place], |[a, b]| op(a, b)))
    }
}

macro_rules! operator {
    ($trait:ident, $method:ident) => {
        impl<P> $trait for Symbol<P> {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                self.binary(other, Op::$trait)
            }
        }
    };
}
operator!(Add, add);
operator!(Sub, sub);
operator!(Mul, mul);
operator!(Div, div);

impl<P> Neg for Symbol<P> {
    type Output = Self;
    fn neg(self) -> Self {
        self.unary(Op::Neg)
    }
}

impl Mask for SymbolMask {
    fn and(self, other: Self) -> Self {
        SymbolMask(record([self.0, other.0], |[a, b]| Op::And(a, b)))
    }
    fn or(self, other: Self) -> Self {
        SymbolMask(record([self.0, other.0], |[a, b]| Op::Or(a, b)))
    }
    fn not(self) -> Self {
        SymbolMask(record([self.0], |[a]| Op::Not(a)))
    }
    fn choose<T: Choose<Self>>(self, yes: impl FnOnce() -> T, no: impl FnOnce() -> T) -> T {
        let yes = yes();
        let no = no();
        T::pick(self, yes, no)
    }
}

impl<P: Significand> Choose<SymbolMask> for Symbol<P> {
    fn pick(mask: SymbolMask, yes: Self, no: Self) -> Self {
        Self::at(record([mask.0, yes.place, no.place], |[m, a, b]| Op::Select(m, a, b)))
    }
}

impl<P: Significand> Nameable for Symbol<P> {
    const NAMES: bool = true;
    fn named(self, name: &str) -> Self {
        SHEET.with_borrow_mut(|sheet| match (sheet, self.place.id) {
            (Some(sheet), Some(id)) if sheet.drawing == self.place.drawing => sheet.graph.name(id, name),
            _ => (),
        });
        self
    }
}

impl Nameable for SymbolMask {
    const NAMES: bool = true;
    fn named(self, name: &str) -> Self {
        Symbol::<Single>::at(self.0).named(name);
        self
    }
}

impl<P: Significand> Real for Symbol<P> {
    type Mask = SymbolMask;
    const PRECISION: Precision = P::PRECISION;

    fn lit(value: f64) -> Self {
        Self::at(record([], |[]| Op::Literal(Literal::new(P::round(value)))))
    }
    fn sqrt(self) -> Self {
        self.unary(Op::Sqrt)
    }
    fn abs(self) -> Self {
        self.unary(Op::Abs)
    }
    fn min(self, other: Self) -> Self {
        self.binary(other, Op::Min)
    }
    fn max(self, other: Self) -> Self {
        self.binary(other, Op::Max)
    }
    fn mul_add(self, factor: Self, addend: Self) -> Self {
        Self::at(record([self.place, factor.place, addend.place], |[a, b, c]| Op::MulAdd(a, b, c)))
    }
    fn lt(self, other: Self) -> SymbolMask {
        self.compare(other, Op::Less)
    }
    fn le(self, other: Self) -> SymbolMask {
        self.compare(other, Op::LessEqual)
    }
    fn equation<T>(id: &'static str, name: &'static str, body: impl FnOnce() -> T) -> T {
        let scopes = |change: &mut dyn FnMut(&mut Vec<Scope>)| {
            SHEET.with_borrow_mut(|sheet| {
                if let Some(sheet) = sheet {
                    change(&mut sheet.scopes);
                }
            });
        };
        scopes(&mut |stack| stack.push(Scope { id, name }));
        let result = body();
        scopes(&mut |stack| _ = stack.pop());
        result
    }
}

/// What the closure of [`draw`] asks for inputs and gives outputs to.
pub struct Pen<P> {
    inputs: Vec<String>,
    outputs: Vec<(String, Symbol<P>)>,
}

impl<P: Significand> Pen<P> {
    /// The input of this name; the same one if it was asked for before.
    pub fn input(&mut self, name: &str) -> Symbol<P> {
        let index = self.inputs.iter().position(|known| known == name).unwrap_or_else(|| {
            self.inputs.push(name.to_string());
            self.inputs.len() - 1
        });
        Symbol::at(record([], |[]| Op::Input(index)))
    }
    /// Gives a result its name. Each name once.
    pub fn output(&mut self, name: &str, value: Symbol<P>) {
        self.outputs.push((name.to_string(), value));
    }
}

/// Takes the sheet away at the end, also when the closure panics: the next drawing starts clean.
struct Clear;
impl Drop for Clear {
    fn drop(&mut self) {
        SHEET.set(None);
    }
}

/// Draws a computation: runs `body` once on symbols and returns what it did. A panic of `body` passes through and leaves
/// nothing behind.
///
/// # Errors
/// [`TraceError::Nested`] inside another `draw` of the same thread, [`TraceError::ForeignSymbol`] if a symbol of another
/// drawing was used, [`TraceError::DuplicateOutput`] if two outputs have one name.
///
/// ```
/// use etalon_kernels_gen::{Real, trace::{draw, Single}};
/// let drawing = draw::<Single>(|pen| {
///     let x = pen.input("x");
///     let y = pen.input("y");
///     pen.output("length", (x.squared() + y.squared()).sqrt());
/// });
/// assert_eq!(drawing?.count().flops(), 4);
/// # Ok::<(), etalon_kernels_gen::trace::TraceError>(())
/// ```
pub fn draw<P: Significand>(body: impl FnOnce(&mut Pen<P>)) -> Result<Drawing, TraceError> {
    let drawing = NEXT_DRAWING.fetch_add(1, Ordering::Relaxed);
    let free = SHEET.with_borrow_mut(|sheet| {
        let free = sheet.is_none();
        sheet.get_or_insert(Sheet { drawing, graph: Graph::default(), scopes: Vec::new(), foreign: false });
        free
    });
    if !free {
        return Err(TraceError::Nested);
    }
    let clear = Clear;
    let mut pen = Pen { inputs: Vec::new(), outputs: Vec::new() };
    body(&mut pen);
    let sheet = SHEET.take();
    drop(clear);
    let Some(sheet) = sheet.filter(|sheet| !sheet.foreign) else { return Err(TraceError::ForeignSymbol) };

    let mut outputs: Vec<Output> = Vec::new();
    for (name, symbol) in pen.outputs {
        let id = symbol.place.id.filter(|_| symbol.place.drawing == drawing).ok_or(TraceError::ForeignSymbol)?;
        if outputs.iter().any(|known| known.name == name) {
            return Err(TraceError::DuplicateOutput { name });
        }
        outputs.push(Output { name, id });
    }
    Ok(Drawing::new(sheet.graph, pen.inputs, outputs, P::PRECISION))
}
