//! The body, translated: what each kind of expression becomes, or why it is refused.

mod branches;
mod calls;
mod comparisons;
mod kinds;
mod literals;
mod statements;

pub(crate) use comparisons::{is_order, order_name};

use crate::errors::Errors;
use crate::mutants::{Mutants, Planted};
use crate::scopes::{Boundary, Scopes};
use proc_macro2::{Span, TokenStream};
use quote::quote_spanned;
use syn::visit_mut::{self, VisitMut};
use syn::{
    Attribute, Block, Expr, ExprClosure, ExprField, ExprIndex, ExprRepeat, GenericArgument, Ident, ItemFn, Pat, Stmt,
    Type,
};

/// Translates a function's body in place; plants its mutants if it is to have any.
pub(crate) fn body(
    function: &mut ItemFn,
    real: &Ident,
    errors: &mut Errors,
    mutants: Option<Mutants>,
) -> Option<Planted> {
    let scopes = Scopes::of_function(&function.sig, real);
    let mut translator = Translator { scopes, errors, constants: 0, mutants };
    translator.visit_block_mut(&mut function.block);
    translator.mutants.map(|mutants| mutants.finish(function, &real.to_string()))
}

pub(crate) struct Translator<'a> {
    pub(crate) scopes: Scopes,
    pub(crate) errors: &'a mut Errors,
    /// How many `R::lit(...)` we are inside of: there, ordinary `f64` arithmetic is meant.
    pub(crate) constants: usize,
    /// The faults that the translation can be given, if it is to have any.
    pub(crate) mutants: Option<Mutants<'a>>,
}

impl Translator<'_> {
    /// Takes the expression out of its place, to build a new one around it.
    pub(crate) fn take(expr: &mut Expr) -> Expr {
        std::mem::replace(expr, Expr::Verbatim(TokenStream::new()))
    }

    /// `<R as Real>::name`, blamed on `span` in the compiler's messages.
    pub(crate) fn real_function(&self, name: &str, span: Span) -> TokenStream {
        let span = generated(span);
        let name = Ident::new(name, span);
        let mut real = self.scopes.real().clone();
        real.set_span(real.span().located_at(span));
        quote_spanned!(span=> <#real as ::etalon_kernels_gen::Real>::#name)
    }

    /// `Mask::name`, blamed on `span`.
    pub(crate) fn mask_function(name: &str, span: Span) -> TokenStream {
        let span = generated(span);
        let name = Ident::new(name, span);
        quote_spanned!(span=> ::etalon_kernels_gen::Mask::#name)
    }

    /// Translates something in a scope of its own.
    pub(crate) fn within(&mut self, boundary: Boundary, translate: impl FnOnce(&mut Self)) {
        self.scopes.open(boundary);
        translate(self);
        self.scopes.close();
    }

    /// What a member or an element is taken of: `TABLE[k]` is one constant, and the table is none.
    fn base(&mut self, base: &mut Expr) {
        match base {
            Expr::Path(_) => self.without_mutants(|this| this.visit_expr_mut(base)),
            // Of `a.b.c` only the last is a number.
            Expr::Field(field) => self.base(&mut field.base),
            _ => self.visit_expr_mut(base),
        }
    }

    fn closure(&mut self, closure: &mut ExprClosure) {
        if let Some(token) = &closure.asyncness {
            self.errors.at(token, "an equation is plain arithmetic: remove `async`");
        }
        self.within(Boundary::Plain, |this| {
            for input in &mut closure.inputs {
                this.visit_pat_mut(input);
                this.scopes.bind_pattern(input, crate::scopes::Kind::Unknown);
            }
            this.visit_return_type_mut(&mut closure.output);
            this.visit_expr_mut(&mut closure.body);
        });
    }
}

/// A span that points where `span` does, for tokens that the author did not write: lints leave them alone.
pub(crate) fn generated(span: Span) -> Span {
    Span::call_site().located_at(span)
}

impl VisitMut for Translator<'_> {
    fn visit_attribute_mut(&mut self, _: &mut Attribute) {}

    fn visit_expr_mut(&mut self, expr: &mut Expr) {
        let written = self.is_mutating().then(|| expr.clone());
        match expr {
            Expr::Lit(literal) => {
                if let Some(new) = self.literal(literal) {
                    *expr = new;
                }
            }
            Expr::Unary(_) => self.unary(expr),
            Expr::Binary(_) => self.binary(expr),
            Expr::If(_) => self.branch(expr),
            Expr::Match(choice) => self.choice(choice),
            Expr::Assign(assignment) => self.assignment(assignment),
            Expr::Reference(reference) => self.reference(reference),
            Expr::Call(call) => self.call(call),
            Expr::MethodCall(call) => self.method_call(call),
            Expr::Path(path) => self.path(path),
            Expr::Cast(cast) => self.cast(cast),
            Expr::Macro(call) => self.macro_call(&call.mac),
            Expr::ForLoop(turns) => self.for_loop(turns),
            Expr::Closure(closure) => self.closure(closure),
            Expr::While(_)
            | Expr::Loop(_)
            | Expr::Return(_)
            | Expr::Try(_)
            | Expr::Break(_)
            | Expr::Continue(_)
            | Expr::Async(_)
            | Expr::Await(_)
            | Expr::Unsafe(_)
            | Expr::Yield(_)
            | Expr::TryBlock(_)
            | Expr::RawAddr(_)
            | Expr::Verbatim(_) => self.refuse_flow(expr),
            // True constants stay as they are.
            Expr::Const(_) => {}
            _ => visit_mut::visit_expr_mut(self, expr),
        }
        if let Some(written) = written {
            self.mutate(&written, expr);
        }
    }

    fn visit_expr_repeat_mut(&mut self, repeat: &mut ExprRepeat) {
        self.visit_expr_mut(&mut repeat.expr);
        self.without_mutants(|this| this.visit_expr_mut(&mut repeat.len));
    }

    fn visit_expr_index_mut(&mut self, index: &mut ExprIndex) {
        self.base(&mut index.expr);
        self.visit_expr_mut(&mut index.index);
    }

    fn visit_expr_field_mut(&mut self, field: &mut ExprField) {
        self.base(&mut field.base);
    }

    fn visit_generic_argument_mut(&mut self, argument: &mut GenericArgument) {
        self.without_mutants(|this| visit_mut::visit_generic_argument_mut(this, argument));
    }

    fn visit_block_mut(&mut self, block: &mut Block) {
        self.within(Boundary::Plain, |this| this.statements(block));
    }

    fn visit_stmt_mut(&mut self, statement: &mut Stmt) {
        self.statement(statement);
    }

    fn visit_pat_mut(&mut self, pattern: &mut Pat) {
        self.pattern(pattern);
        visit_mut::visit_pat_mut(self, pattern);
    }

    fn visit_type_mut(&mut self, ty: &mut Type) {
        if self.constants == 0
            && let Some(name) = crate::signature::float_name(ty)
        {
            let real = self.scopes.real();
            self.errors
                .at(&*ty, format!("a value of an equation has its number type: write `{real}` instead of `{name}`"));
            return;
        }
        self.without_mutants(|this| visit_mut::visit_type_mut(this, ty));
    }
}
