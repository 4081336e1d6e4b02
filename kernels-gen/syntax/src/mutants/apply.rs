//! Which variants an expression has: arithmetic, signs and comparisons here, the rest in the files beside.

use super::{Variants, text};
use crate::scopes::Kind;
use crate::translate::Translator;
use proc_macro2::{Span, TokenStream};
use quote::{ToTokens, quote};
use syn::spanned::Spanned;
use syn::{BinOp, Expr, ExprBinary, Lit, UnOp};

/// Names of our own, kept apart from the author's by hygiene.
pub(super) fn held(name: &str) -> syn::Ident {
    syn::Ident::new(name, Span::mixed_site())
}

/// The helpers that look at types.
pub(super) fn helper(name: &str) -> TokenStream {
    let name = held(name);
    quote!(::etalon_kernels_gen::__private::mutants::#name)
}

impl Translator<'_> {
    /// Whether variants are wanted here.
    pub(crate) fn is_mutating(&self) -> bool {
        self.mutants.as_ref().is_some_and(|mutants| !mutants.is_paused())
    }

    /// Translates something that has to stay as it is.
    pub(crate) fn without_mutants(&mut self, translate: impl FnOnce(&mut Self)) {
        if let Some(mutants) = &mut self.mutants {
            mutants.pause();
        }
        translate(self);
        if let Some(mutants) = &mut self.mutants {
            mutants.go_on();
        }
    }

    /// Enters a mutant and adds its variant.
    pub(super) fn variant(
        &mut self,
        variants: &mut Variants,
        operator: &'static str,
        span: Span,
        change: (String, String),
        value: TokenStream,
    ) {
        if let Some(mutants) = &mut self.mutants {
            let is_active = mutants.enter(operator, span, change.0, change.1);
            variants.add(is_active, value);
        }
    }

    /// Puts the variants of an expression around its translation.
    pub(crate) fn mutate(&mut self, written: &Expr, translated: &mut Expr) {
        match written {
            Expr::Lit(literal) => match &literal.lit {
                Lit::Float(_) | Lit::Int(_) => self.mutate_literal(written, &literal.lit, false, translated),
                _ => {}
            },
            Expr::Unary(unary) => match (&unary.op, &*unary.expr) {
                (UnOp::Neg(_), Expr::Lit(literal)) => self.mutate_literal(written, &literal.lit, true, translated),
                (UnOp::Neg(minus), operand) => self.mutate_sign(written, operand, minus.span(), translated),
                (UnOp::Not(not), operand) if self.kind(operand) == Kind::Mask => {
                    let mut variants = Variants::default();
                    let mask = held("mask");
                    let not_function = Self::mask_function("not", not.span());
                    let change = (text(written), text(operand));
                    self.variant(&mut variants, "dropped", not.span(), change, quote!(#not_function(#mask)));
                    let choice = variants.or(mask.to_token_stream());
                    *translated = Expr::Verbatim(quote!(({ let #mask = #translated; #choice })));
                }
                _ => {}
            },
            Expr::Binary(binary) => self.mutate_binary(written, binary, translated),
            Expr::Call(call) => self.mutate_call(written, call, translated),
            Expr::MethodCall(call) => self.mutate_method(written, call, translated),
            Expr::Path(path) if self.constants == 0 => self.mutate_name(path, translated),
            Expr::Cast(_) | Expr::Path(_) | Expr::Field(_) | Expr::Index(_) => {
                self.mutate_constant(written, translated)
            }
            Expr::Match(choice) => self.mutate_arms(choice, translated),
            Expr::Struct(_) | Expr::Tuple(_) | Expr::Array(_) => self.mutate_parts(written, translated),
            _ => {}
        }
    }

    /// A parameter taken for another one of its type.
    fn mutate_name(&mut self, written: &syn::ExprPath, translated: &mut Expr) {
        let Some(name) = written.path.get_ident() else { return };
        let Some(other) = self.scopes.mistakable(name).cloned() else { return };
        let mut variants = Variants::default();
        self.variant(
            &mut variants,
            "name",
            name.span(),
            (name.to_string(), other.to_string()),
            other.to_token_stream(),
        );
        let choice = variants.or(translated.to_token_stream());
        *translated = Expr::Verbatim(quote!(({ #choice })));
    }

    /// `-x` without its sign.
    fn mutate_sign(&mut self, written: &Expr, operand: &Expr, span: Span, translated: &mut Expr) {
        let Expr::Unary(unary) = &*translated else { return };
        let mut variants = Variants::default();
        let value = held("value");
        self.variant(&mut variants, "sign", span, (text(written), text(operand)), value.to_token_stream());
        let choice = variants.or(quote!(-#value));
        let inner = &unary.expr;
        *translated = Expr::Verbatim(quote!(({ let #value = #inner; #choice })));
    }

    fn mutate_binary(&mut self, written: &Expr, binary: &ExprBinary, translated: &mut Expr) {
        // Comparisons of reals and what joins them have become calls: see `mutate_comparison` and `mutate_joined`.
        let Expr::Binary(result) = &*translated else { return };
        let (left, right) = (held("left"), held("right"));
        let mut variants = Variants::default();
        // Plain numbers have all operators; of anything else a helper finds out.
        let kinds = [self.kind(&binary.left), self.kind(&binary.right)];
        let is_plain = self.constants > 0 || kinds == [Kind::Real; 2] || kinds.contains(&Kind::Integer);
        let arithmetic = helper("Arithmetic");
        let with = |method: &str, plain: TokenStream| {
            let method = held(method);
            if is_plain { plain } else { quote!(#arithmetic::of(&#left, &#right).#method(#left, #right)) }
        };
        let span = binary.op.span();
        let exchanged = |operator: BinOp| {
            let other = ExprBinary { op: operator, ..binary.clone() };
            (text(written), text(other))
        };
        match binary.op {
            BinOp::Add(_) => {
                let value = with("difference", quote!(#left - #right));
                self.variant(&mut variants, "arithmetic", span, exchanged(BinOp::Sub(Default::default())), value);
            }
            BinOp::Sub(_) => {
                let value = with("sum", quote!(#left + #right));
                self.variant(&mut variants, "arithmetic", span, exchanged(BinOp::Add(Default::default())), value);
                let other = ExprBinary { left: binary.right.clone(), right: binary.left.clone(), ..binary.clone() };
                let value = with("reversed_difference", quote!(#right - #left));
                self.variant(&mut variants, "swapped", span, (text(written), text(other)), value);
            }
            BinOp::Mul(_) => {
                let value = with("quotient", quote!(#left / #right));
                self.variant(&mut variants, "arithmetic", span, exchanged(BinOp::Div(Default::default())), value);
            }
            BinOp::Div(_) => {
                let value = with("product", quote!(#left * #right));
                self.variant(&mut variants, "arithmetic", span, exchanged(BinOp::Mul(Default::default())), value);
            }
            ref order if crate::translate::is_order(order) => {
                let (turned, other) = other_orders(order);
                for (operator, name) in [(turned, "direction"), (other, "strictness")] {
                    let value = quote!(#left #operator #right);
                    self.variant(&mut variants, name, span, exchanged(operator), value);
                }
            }
            _ => return,
        }
        let (operator, l, r) = (&binary.op, &result.left, &result.right);
        let choice = variants.or(quote!(#left #operator #right));
        *translated = Expr::Verbatim(quote!(({ let #left = #l; let #right = #r; #choice })));
    }

    /// `sum = sum + x` with the opposite operator.
    pub(crate) fn mutate_accumulation(
        &mut self,
        binary: &ExprBinary,
        place: TokenStream,
        operator: TokenStream,
        value: TokenStream,
    ) -> TokenStream {
        let (other, method): (BinOp, &str) = match binary.op {
            BinOp::AddAssign(_) => (BinOp::SubAssign(Default::default()), "difference"),
            BinOp::SubAssign(_) => (BinOp::AddAssign(Default::default()), "sum"),
            BinOp::MulAssign(_) => (BinOp::DivAssign(Default::default()), "quotient"),
            _ => (BinOp::MulAssign(Default::default()), "product"),
        };
        let (left, right, method) = (held("left"), held("right"), held(method));
        let arithmetic = helper("Arithmetic");
        let mut variants = Variants::default();
        let change = (text(binary), text(ExprBinary { op: other, ..binary.clone() }));
        let faulty = quote!(#arithmetic::of(&#left, &#right).#method(#left, #right));
        self.variant(&mut variants, "arithmetic", binary.op.span(), change, faulty);
        let choice = variants.or(quote!(#left #operator #right));
        quote!(#place = { let #left = #place; let #right = #value; #choice })
    }

    /// `R::lt(a, b)` in its other directions.
    pub(crate) fn mutate_comparison(
        &mut self,
        binary: &ExprBinary,
        call: TokenStream,
        sides: [Expr; 2],
    ) -> TokenStream {
        let (left, right) = (held("left"), held("right"));
        let mut variants = Variants::default();
        let (turned, other) = other_orders(&binary.op);
        for (operator, name) in [(turned, "direction"), (other, "strictness")] {
            let function = self.real_function(crate::translate::order_name(&operator), binary.op.span());
            let change = (text(binary), text(ExprBinary { op: operator, ..binary.clone() }));
            self.variant(&mut variants, name, binary.op.span(), change, quote!(#function(#left, #right)));
        }
        let choice = variants.or(quote!(#call(#left, #right)));
        let [l, r] = sides;
        quote!(({ let #left = #l; let #right = #r; #choice }))
    }

    /// `Mask::and(a, b)` as `Mask::or(a, b)`, and the other way round.
    pub(crate) fn mutate_joined(&mut self, binary: &ExprBinary, call: TokenStream, sides: [Expr; 2]) -> TokenStream {
        let (left, right) = (held("left"), held("right"));
        let mut variants = Variants::default();
        let (operator, name) = match binary.op {
            BinOp::And(_) => (BinOp::Or(Default::default()), "or"),
            _ => (BinOp::And(Default::default()), "and"),
        };
        let function = Self::mask_function(name, binary.op.span());
        let change = (text(binary), text(ExprBinary { op: operator, ..binary.clone() }));
        self.variant(&mut variants, "logic", binary.op.span(), change, quote!(#function(#left, #right)));
        let choice = variants.or(quote!(#call(#left, #right)));
        let [l, r] = sides;
        quote!(({ let #left = #l; let #right = #r; #choice }))
    }
}

/// The opposite direction, and the same one with or without equality.
pub(super) fn other_orders(operator: &BinOp) -> (BinOp, BinOp) {
    let (less, more) = (BinOp::Lt(Default::default()), BinOp::Gt(Default::default()));
    let (at_most, at_least) = (BinOp::Le(Default::default()), BinOp::Ge(Default::default()));
    match operator {
        BinOp::Lt(_) => (more, at_most),
        BinOp::Le(_) => (at_least, less),
        BinOp::Gt(_) => (less, at_least),
        _ => (at_most, more),
    }
}
