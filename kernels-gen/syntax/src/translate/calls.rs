//! Calls, paths and casts.

use super::Translator;
use crate::advice::{Reason, refusal, sentence};
use crate::scopes::Kind;
use crate::signature::float_name;
use syn::visit_mut::{self, VisitMut};
use syn::{Expr, ExprCall, ExprCast, ExprMethodCall, ExprPath, Ident, parse_quote};

impl Translator<'_> {
    pub(crate) fn call(&mut self, call: &mut ExprCall) {
        if let Expr::Path(path) = &*call.func {
            if path.path.is_ident("rare") {
                self.errors.at(
                    path,
                    "`rare` stands around the whole condition of an `if`: `if rare(a < b) { .. } else { .. }`",
                );
            }
            if path.path.segments.len() > 1 && path.path.segments.last().is_some_and(|s| s.ident == "lit") {
                self.constants += 1;
                self.without_mutants(|this| this.visit_expr_mut(&mut call.func));
                call.args.iter_mut().for_each(|argument| self.visit_expr_mut(argument));
                self.constants -= 1;
                return;
            }
            if let Some(name) = path.path.segments.last() {
                self.refuse_function(&name.ident, Kind::Unknown);
            }
        } else {
            self.visit_expr_mut(&mut call.func);
        }
        for argument in &mut call.args {
            self.visit_expr_mut(argument);
            inline(argument);
        }
    }

    pub(crate) fn method_call(&mut self, call: &mut ExprMethodCall) {
        let receiver = self.kind(&call.receiver);
        self.refuse_function(&call.method, receiver);
        self.visit_expr_mut(&mut call.receiver);
        if let Some(arguments) = &mut call.turbofish {
            self.visit_angle_bracketed_generic_arguments_mut(arguments);
        }
        for argument in &mut call.args {
            self.visit_expr_mut(argument);
            inline(argument);
        }
    }

    /// A function handed over by its path, as `f64::sin`. A plain name is a variable.
    pub(crate) fn path(&mut self, path: &mut ExprPath) {
        if path.path.segments.len() > 1
            && let Some(name) = path.path.segments.last()
        {
            self.refuse_function(&name.ident, Kind::Unknown);
        }
        visit_mut::visit_expr_path_mut(self, path);
    }

    fn refuse_function(&mut self, name: &Ident, receiver: Kind) {
        let text = name.to_string();
        let Some((reason, advice)) = refusal(&text) else { return };
        if self.constants > 0 {
            // Constants are plain f64: exact operations are welcome, the platform's own transcendentals are not.
            if reason == Reason::Transcendental {
                self.errors.at(
                    name,
                    format!("`{text}` differs from one platform's library to the next; write the constant's digits"),
                );
            }
        } else if receiver != Kind::Integer {
            self.errors.at(name, sentence(&text, reason, advice));
        }
    }

    pub(crate) fn cast(&mut self, cast: &mut ExprCast) {
        if self.constants == 0 {
            let real = self.scopes.real();
            if let Some(name) = float_name(&cast.ty) {
                self.errors.at(
                    cast.as_token,
                    format!("`as {name}` leaves the equation's number type: write `{real}::lit(n as f64)` for a whole number `n`"),
                );
                self.visit_expr_mut(&mut cast.expr);
                return;
            }
            if self.kind(&cast.expr) == Kind::Real || self.scopes.kind_of_type(&cast.ty) == Kind::Real {
                self.errors.at(
                    cast.as_token,
                    format!("reals are not cast: a constant is `{real}::lit(..)`, and no target rounds a real to a whole number"),
                );
            }
        }
        // A cast is mutated as a whole.
        self.without_mutants(|this| visit_mut::visit_expr_cast_mut(this, cast));
    }
}

/// A closure handed to a function must be inlined with it, or the lanes lose their instructions.
fn inline(argument: &mut Expr) {
    if let Expr::Closure(closure) = argument
        && !closure.attrs.iter().any(|attribute| attribute.path().is_ident("inline"))
    {
        closure.attrs.push(parse_quote!(#[inline(always)]));
    }
}
