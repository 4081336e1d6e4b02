//! What an expression surely is, as far as its text tells.

use super::Translator;
use super::comparisons::is_order;
use crate::scopes::Kind;
use syn::{BinOp, Expr, ExprBinary, ExprCall, ExprMethodCall, ExprPath, Ident, Lit, UnOp};

impl Translator<'_> {
    /// The kind of an expression that has not been translated yet.
    pub(crate) fn kind(&self, expr: &Expr) -> Kind {
        match expr {
            Expr::Lit(literal) => match &literal.lit {
                Lit::Int(_) => Kind::Integer,
                Lit::Float(_) => Kind::Real,
                Lit::Bool(_) => Kind::Flag,
                _ => Kind::Unknown,
            },
            Expr::Paren(inner) => self.kind(&inner.expr),
            Expr::Group(inner) => self.kind(&inner.expr),
            Expr::Reference(inner) => self.kind(&inner.expr),
            Expr::Unary(unary) => match unary.op {
                // `!` keeps what it is applied to: a mask, a flag, the bits of an integer.
                UnOp::Neg(_) | UnOp::Not(_) | UnOp::Deref(_) => self.kind(&unary.expr),
                _ => Kind::Unknown,
            },
            Expr::Path(path) => single_name(path).map_or(Kind::Unknown, |name| self.scopes.kind_of_name(name)),
            Expr::Binary(binary) => self.kind_of_binary(binary),
            Expr::Cast(cast) => self.scopes.kind_of_type(&cast.ty),
            Expr::Call(call) => self.kind_of_call(call),
            Expr::MethodCall(call) => self.kind_of_method(call),
            Expr::Macro(call) if call.mac.path.segments.last().is_some_and(|s| s.ident == "matches") => Kind::Flag,
            _ => Kind::Unknown,
        }
    }

    fn kind_of_binary(&self, binary: &ExprBinary) -> Kind {
        if is_order(&binary.op) {
            return if self.compares_integers(binary) { Kind::Flag } else { Kind::Mask };
        }
        let sides = [self.kind(&binary.left), self.kind(&binary.right)];
        let some = |kind| sides.contains(&kind);
        match binary.op {
            BinOp::Eq(_) | BinOp::Ne(_) => Kind::Flag,
            BinOp::And(_) | BinOp::Or(_) => {
                if some(Kind::Mask) {
                    Kind::Mask
                } else if sides == [Kind::Flag; 2] {
                    Kind::Flag
                } else {
                    Kind::Unknown
                }
            }
            BinOp::Add(_) | BinOp::Sub(_) | BinOp::Mul(_) | BinOp::Div(_) | BinOp::Rem(_) => {
                // A vector times a real is a vector, so a real side tells nothing of the whole unless both are.
                if some(Kind::Integer) {
                    Kind::Integer
                } else if sides == [Kind::Real; 2] {
                    Kind::Real
                } else {
                    Kind::Unknown
                }
            }
            BinOp::Shl(_) | BinOp::Shr(_) => Kind::Integer,
            _ => Kind::Unknown,
        }
    }

    fn kind_of_call(&self, call: &ExprCall) -> Kind {
        let Expr::Path(path) = &*call.func else { return Kind::Unknown };
        if path.path.is_ident("rare") {
            return Kind::Mask;
        }
        let mut names = path.path.segments.iter().rev();
        let (Some(name), Some(owner)) = (names.next(), names.next()) else { return Kind::Unknown };
        if owner.ident != *self.scopes.real() && owner.ident != "Real" {
            return Kind::Unknown;
        }
        match name.ident.to_string().as_str() {
            "lt" | "le" | "gt" | "ge" => Kind::Mask,
            "pick" | "equation" => Kind::Unknown,
            _ => Kind::Real,
        }
    }

    fn kind_of_method(&self, call: &ExprMethodCall) -> Kind {
        let receiver = || self.kind(&call.receiver);
        match call.method.to_string().as_str() {
            "lt" | "le" | "gt" | "ge" => {
                if receiver() == Kind::Integer {
                    Kind::Flag
                } else {
                    Kind::Mask
                }
            }
            "and" | "or" | "not" | "abs" | "min" | "max" | "pow" | "clamp" | "rem_euclid" | "div_euclid" => receiver(),
            "sqrt" | "squared" | "mul_add" | "power" | "dot" | "norm" | "norm_squared" => Kind::Real,
            "len" | "count" => Kind::Integer,
            _ => Kind::Unknown,
        }
    }
}

/// The name, where a path is nothing else.
pub(crate) fn single_name(path: &ExprPath) -> Option<&Ident> {
    if path.qself.is_some() {
        return None;
    }
    path.path.get_ident()
}
