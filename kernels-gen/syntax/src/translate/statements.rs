//! Statements: names, assignments, loops, and what may not be done.

use super::{Translator, generated};
use crate::scopes::{Boundary, Kind};
use proc_macro2::Span;
use quote::{ToTokens, quote_spanned};
use syn::spanned::Spanned;
use syn::visit_mut::{self, VisitMut};
use syn::{Block, Expr, ExprAssign, ExprForLoop, ExprReference, Ident, Item, Local, Pat, Stmt};

impl Translator<'_> {
    /// A block's statements, in the scope that the caller opened.
    pub(crate) fn statements(&mut self, block: &mut Block) {
        let last = block.stmts.len().saturating_sub(1);
        for (i, statement) in block.stmts.iter_mut().enumerate() {
            if let Stmt::Expr(Expr::If(branch), semicolon) = statement
                && (semicolon.is_some() || i != last)
                && branch.else_branch.is_some()
                && self.is_dependent(branch)
            {
                self.errors.at(
                    branch.if_token,
                    "the value that is picked here goes nowhere: write `let x = if a < b { .. } else { .. };`",
                );
            }
            self.visit_stmt_mut(statement);
        }
    }

    pub(crate) fn statement(&mut self, statement: &mut Stmt) {
        match statement {
            Stmt::Local(local) => self.local(local),
            Stmt::Item(Item::Const(_) | Item::Use(_)) => {}
            Stmt::Item(item) => self.errors.at(
                &*item,
                "only `const` and `use` stand inside an equation: move this beside it, with its own #[equation] if it is one",
            ),
            Stmt::Macro(call) => self.macro_call(&call.mac),
            Stmt::Expr(expr, _) => self.visit_expr_mut(expr),
        }
    }

    /// `let name = value;` gives the value its name.
    fn local(&mut self, local: &mut Local) {
        let kind = match &local.pat {
            Pat::Type(typed) => self.scopes.kind_of_type(&typed.ty),
            _ => local.init.as_ref().map_or(Kind::Unknown, |init| self.kind(&init.expr)),
        };
        self.visit_pat_mut(&mut local.pat);
        if let Some(init) = &mut local.init {
            let named = if init.diverge.is_none() { self.wants_name(&local.pat, &init.expr, kind) } else { None };
            self.visit_expr_mut(&mut init.expr);
            if let Some((_, otherwise)) = &mut init.diverge {
                self.visit_expr_mut(otherwise);
            }
            if let Some(name) = named {
                let value = Self::take(&mut init.expr);
                *init.expr = name_value(&name, &local.pat, value);
            }
        }
        self.scopes.bind_pattern(&local.pat, kind);
    }

    /// The name for drawings, unless the value cannot be drawn or the name would be wrong: a variable that changes does not
    /// stay what it started as.
    fn wants_name(&self, pattern: &Pat, value: &Expr, kind: Kind) -> Option<Ident> {
        let pattern = match pattern {
            Pat::Type(typed) => &*typed.pat,
            other => other,
        };
        let Pat::Ident(name) = pattern else { return None };
        let is_plain = name.mutability.is_none() && name.by_ref.is_none() && name.subpat.is_none();
        let is_number = matches!(kind, Kind::Real | Kind::Unknown);
        // References and aggregates have no name of their own, and wrapping them would shorten the lives of temporaries.
        let is_aggregate = matches!(
            value,
            Expr::Reference(_)
                | Expr::Closure(_)
                | Expr::Macro(_)
                | Expr::Tuple(_)
                | Expr::Array(_)
                | Expr::Repeat(_)
                | Expr::Range(_)
                | Expr::Struct(_)
                | Expr::Const(_)
        );
        let is_used = !name.ident.to_string().starts_with('_');
        (is_plain && is_number && !is_aggregate && is_used && self.constants == 0).then(|| name.ident.clone())
    }

    pub(crate) fn assignment(&mut self, assignment: &mut ExprAssign) {
        self.refuse_change(&assignment.left);
        self.without_mutants(|this| this.visit_expr_mut(&mut assignment.left));
        self.visit_expr_mut(&mut assignment.right);
    }

    /// `sum += x` as `sum = sum + x`: the number trait has no `+=`, which symbols could not record. Places that would have to
    /// be computed twice keep it.
    pub(crate) fn compound_assignment(&mut self, expr: &mut Expr) {
        use syn::BinOp::{AddAssign, DivAssign, MulAssign, SubAssign};
        let Expr::Binary(binary) = expr else { return };
        self.refuse_change(&binary.left);
        let is_integer = self.kind(&binary.left) == Kind::Integer;
        let written = self.is_mutating().then(|| binary.clone());
        self.without_mutants(|this| this.visit_expr_mut(&mut binary.left));
        self.visit_expr_mut(&mut binary.right);
        let span = generated(binary.op.span());
        let operator = match binary.op {
            AddAssign(_) => quote_spanned!(span=> +),
            SubAssign(_) => quote_spanned!(span=> -),
            MulAssign(_) => quote_spanned!(span=> *),
            DivAssign(_) => quote_spanned!(span=> /),
            _ => return,
        };
        if is_integer || !is_simple_place(&binary.left) {
            return;
        }
        let (place, value) = (&binary.left, &binary.right);
        let value = match &**value {
            simple @ (Expr::Path(_)
            | Expr::Lit(_)
            | Expr::Call(_)
            | Expr::MethodCall(_)
            | Expr::Verbatim(_)
            | Expr::Paren(_)) => simple.to_token_stream(),
            other => quote_spanned!(span=> (#other)),
        };
        *expr = Expr::Verbatim(match written {
            Some(written) => self.mutate_accumulation(&written, place.to_token_stream(), operator, value),
            None => quote_spanned!(span=> #place = #place #operator #value),
        });
    }

    pub(crate) fn reference(&mut self, reference: &mut ExprReference) {
        if reference.mutability.is_some() {
            self.refuse_change(&reference.expr);
        }
        self.visit_expr_mut(&mut reference.expr);
    }

    /// Refuses to change, inside a data-dependent branch, what was declared outside of it.
    fn refuse_change(&mut self, place: &Expr) {
        if let Expr::Tuple(tuple) = place {
            tuple.elems.iter().for_each(|element| self.refuse_change(element));
            return;
        }
        if let Some(name) = root(place)
            && self.scopes.is_outside_branch(name)
        {
            self.errors.at(
                place,
                format!(
                    "both sides of this `if` may run, so neither may change `{name}`: let the `if` give the value, `if a < b {{ new }} \
                     else {{ old }}`, and assign that"
                ),
            );
        }
    }

    pub(crate) fn for_loop(&mut self, turns: &mut ExprForLoop) {
        if !is_range(&turns.expr) {
            self.errors.at(
                &turns.expr,
                "a loop is unrolled while generating: write `for i in 0..n` over whole numbers, and index with `i`",
            );
        }
        if matches!(self.kind_of_range(&turns.expr), Kind::Real) {
            self.errors.at(&turns.expr, "a loop runs over whole numbers: write `for i in 0..n`");
        }
        self.visit_expr_mut(&mut turns.expr);
        self.within(Boundary::Loop, |this| {
            this.visit_pat_mut(&mut turns.pat);
            this.scopes.bind_pattern(&turns.pat, Kind::Integer);
            this.visit_block_mut(&mut turns.body);
        });
    }

    fn kind_of_range(&self, expr: &Expr) -> Kind {
        let Expr::Range(range) = expr else { return Kind::Unknown };
        let bounds = [&range.start, &range.end].into_iter().flatten();
        let mut kinds = bounds.map(|bound| self.kind(bound));
        if kinds.any(|kind| kind == Kind::Real) { Kind::Real } else { Kind::Integer }
    }

    /// What would need control flow that lanes and symbols do not have.
    pub(crate) fn refuse_flow(&mut self, expr: &mut Expr) {
        let turns = "the number of turns must be known while generating: write `for i in 0..n`";
        let early = "both sides of a branch run on vector lanes, so nothing leaves early: make it the value of the last expression, `if a < b { x } else { y }`";
        let plain = "an equation is plain arithmetic: remove this";
        let (span, message): (Span, &str) = match &*expr {
            Expr::While(inner) => (inner.while_token.span(), turns),
            Expr::Loop(inner) => (inner.loop_token.span(), turns),
            Expr::Return(inner) => (inner.return_token.span(), early),
            Expr::Try(inner) => (inner.question_token.span(), early),
            Expr::Break(inner) => {
                if self.scopes.break_leaves_branch(inner.label.is_some()) {
                    self.errors.at(inner.break_token, "a loop cannot end for one lane and go on for another: let the branch give a value that changes nothing, such as `0.0`");
                }
                visit_mut::visit_expr_mut(self, expr);
                return;
            }
            Expr::Continue(inner) => {
                if self.scopes.break_leaves_branch(inner.label.is_some()) {
                    self.errors.at(inner.continue_token, "a turn cannot end for one lane and go on for another: let the branch give a value that changes nothing, such as `0.0`");
                }
                return;
            }
            Expr::Async(inner) => (inner.async_token.span(), plain),
            Expr::Await(inner) => (inner.await_token.span(), plain),
            Expr::Unsafe(inner) => (inner.unsafe_token.span(), plain),
            Expr::RawAddr(inner) => (inner.raw.span(), plain),
            other => (other.span(), "this is no part of the equation language: see kernels-gen/syntax/README.md"),
        };
        self.errors.at_span(span, message);
        match expr {
            // Look inside, so that all errors come in one go.
            Expr::While(inner) => self.within(Boundary::Loop, |this| this.visit_block_mut(&mut inner.body)),
            Expr::Loop(inner) => self.within(Boundary::Loop, |this| this.visit_block_mut(&mut inner.body)),
            Expr::Return(_) | Expr::Try(_) | Expr::Await(_) | Expr::Unsafe(_) => visit_mut::visit_expr_mut(self, expr),
            _ => {}
        }
    }
}

/// `value`, known as `name` if its type can be.
fn name_value(name: &Ident, pattern: &Pat, value: Expr) -> Expr {
    let text = crate::emit::unraw(name);
    let span = generated(name.span());
    // Hygiene keeps this apart from the author's names.
    let held = Ident::new("value", Span::mixed_site().located_at(name.span()));
    let ty = match pattern {
        Pat::Type(typed) => {
            let ty = &typed.ty;
            quote_spanned!(span=> : #ty)
        }
        _ => quote_spanned!(span=>),
    };
    Expr::Verbatim(quote_spanned! {span=> {
        let #held #ty = #value;
        ::etalon_kernels_gen::__private::Naming::of(&#held).name(#held, #text)
    }})
}

/// The variable that a place belongs to.
fn root(place: &Expr) -> Option<&Ident> {
    match place {
        Expr::Path(path) => super::kinds::single_name(path),
        Expr::Field(field) => root(&field.base),
        Expr::Index(index) => root(&index.expr),
        Expr::Paren(inner) => root(&inner.expr),
        Expr::Group(inner) => root(&inner.expr),
        Expr::Unary(unary) if matches!(unary.op, syn::UnOp::Deref(_)) => root(&unary.expr),
        _ => None,
    }
}

/// A place that can be named twice: variables, members, and elements at plain indices.
fn is_simple_place(place: &Expr) -> bool {
    match place {
        Expr::Path(_) => true,
        Expr::Field(field) => is_simple_place(&field.base),
        Expr::Index(index) => is_simple_place(&index.expr) && matches!(&*index.index, Expr::Path(_) | Expr::Lit(_)),
        Expr::Unary(unary) => matches!(unary.op, syn::UnOp::Deref(_)) && is_simple_place(&unary.expr),
        Expr::Paren(inner) => is_simple_place(&inner.expr),
        _ => false,
    }
}

/// `a..b`, `a..=b`, and these in reverse or in steps.
fn is_range(expr: &Expr) -> bool {
    match expr {
        Expr::Range(range) => range.start.is_some() && range.end.is_some(),
        Expr::Paren(inner) => is_range(&inner.expr),
        Expr::Group(inner) => is_range(&inner.expr),
        Expr::MethodCall(call) => (call.method == "rev" || call.method == "step_by") && is_range(&call.receiver),
        _ => false,
    }
}
