//! What the macro can know of a name: macros see no types, so only what the text itself says.

use crate::signature::is_identifier;
use quote::ToTokens;
use std::collections::HashMap;
use syn::{FnArg, GenericParam, Ident, Pat, Signature, Type};

/// What a value surely is, as far as the text tells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// A whole number: a loop variable, a const parameter, a literal.
    Integer,
    /// The number type.
    Real,
    /// The outcome of comparing reals: one truth value per particle.
    Mask,
    /// A truth value that is known while generating.
    Flag,
    /// Anything.
    Unknown,
}

/// Why a scope was opened.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Boundary {
    /// A block, a match arm, a closure.
    Plain,
    /// The body of a loop.
    Loop,
    /// One side of a data-dependent `if`: it becomes a closure.
    Branch,
}

struct Scope {
    boundary: Boundary,
    names: HashMap<String, Kind>,
}

/// The names in sight, innermost scope last.
pub(crate) struct Scopes {
    real: Ident,
    /// Whole numbers that the function is generic over.
    sizes: Vec<Ident>,
    /// The function's parameters that are names, with the text of their types.
    parameters: Vec<(Ident, String)>,
    stack: Vec<Scope>,
}

impl Scopes {
    /// The scope of a function's parameters.
    pub(crate) fn of_function(signature: &Signature, real: &Ident) -> Self {
        let mut scopes = Scopes { real: real.clone(), sizes: Vec::new(), parameters: Vec::new(), stack: Vec::new() };
        scopes.open(Boundary::Plain);
        for parameter in &signature.generics.params {
            if let GenericParam::Const(parameter) = parameter {
                let kind = scopes.kind_of_type(&parameter.ty);
                scopes.bind(&parameter.ident, kind);
                if kind == Kind::Integer {
                    scopes.sizes.push(parameter.ident.clone());
                }
            }
        }
        for input in &signature.inputs {
            if let FnArg::Typed(input) = input {
                let kind = scopes.kind_of_type(&input.ty);
                scopes.bind_pattern(&input.pat, kind);
                if let Pat::Ident(name) = &*input.pat
                    && !matches!(kind, Kind::Integer | Kind::Flag | Kind::Mask)
                {
                    scopes.parameters.push((name.ident.clone(), input.ty.to_token_stream().to_string()));
                }
            }
        }
        scopes
    }

    pub(crate) fn real(&self) -> &Ident {
        &self.real
    }

    /// Whole numbers that the function is generic over, such as the dimension.
    pub(crate) fn sizes(&self) -> &[Ident] {
        &self.sizes
    }

    /// The parameter that this one may be taken for: the next of its type, behind the last of them the first.
    pub(crate) fn mistakable(&self, name: &Ident) -> Option<&Ident> {
        let at = self.parameters.iter().position(|(parameter, _)| parameter == name)?;
        let (before, after) = self.parameters.split_at(at);
        let ((_, own_type), after) = after.split_first()?;
        let (other, _) = after.iter().chain(before).find(|(_, other_type)| other_type == own_type)?;
        let is_hidden = |name: &Ident| self.stack.iter().skip(1).any(|s| s.names.contains_key(&name.to_string()));
        (!is_hidden(name) && !is_hidden(other)).then_some(other)
    }

    pub(crate) fn open(&mut self, boundary: Boundary) {
        self.stack.push(Scope { boundary, names: HashMap::new() });
    }

    pub(crate) fn close(&mut self) {
        self.stack.pop();
    }

    pub(crate) fn bind(&mut self, name: &Ident, kind: Kind) {
        if let Some(scope) = self.stack.last_mut() {
            scope.names.insert(name.to_string(), kind);
        }
    }

    /// Binds every name of a pattern; `kind` is that of the whole value.
    pub(crate) fn bind_pattern(&mut self, pattern: &Pat, kind: Kind) {
        match pattern {
            Pat::Ident(name) => self.bind(&name.ident, kind),
            Pat::Type(typed) => {
                let kind = self.kind_of_type(&typed.ty);
                self.bind_pattern(&typed.pat, kind);
            }
            Pat::Paren(inner) => self.bind_pattern(&inner.pat, kind),
            Pat::Reference(inner) => self.bind_pattern(&inner.pat, kind),
            other => {
                let mut names = Names(Vec::new());
                syn::visit::Visit::visit_pat(&mut names, other);
                for name in names.0 {
                    self.bind(&name, Kind::Unknown);
                }
            }
        }
    }

    /// What is known of a name.
    pub(crate) fn kind_of_name(&self, name: &Ident) -> Kind {
        let text = name.to_string();
        let known = self.stack.iter().rev().find_map(|scope| scope.names.get(&text).copied());
        // One upper-case letter that is not a local name: a const parameter of the surrounding `impl`.
        let is_const_parameter = || text.len() == 1 && text.chars().all(|c| c.is_ascii_uppercase());
        known.unwrap_or_else(|| if is_const_parameter() { Kind::Integer } else { Kind::Unknown })
    }

    /// What is known of a value of this type.
    pub(crate) fn kind_of_type(&self, ty: &Type) -> Kind {
        const INTEGERS: [&str; 12] =
            ["usize", "u8", "u16", "u32", "u64", "u128", "isize", "i8", "i16", "i32", "i64", "i128"];
        match ty {
            Type::Reference(inner) => self.kind_of_type(&inner.elem),
            Type::Paren(inner) => self.kind_of_type(&inner.elem),
            Type::Group(inner) => self.kind_of_type(&inner.elem),
            ty if is_identifier(ty, &self.real) => Kind::Real,
            Type::Path(path) if path.path.segments.last().is_some_and(|s| s.ident == "Mask") => Kind::Mask,
            ty => {
                let text = ty.to_token_stream().to_string();
                if INTEGERS.contains(&text.as_str()) {
                    Kind::Integer
                } else if text == "bool" {
                    Kind::Flag
                } else {
                    Kind::Unknown
                }
            }
        }
    }

    /// Whether a name was declared outside the data-dependent branch we are in, if we are in one.
    pub(crate) fn is_outside_branch(&self, name: &Ident) -> bool {
        let text = name.to_string();
        for scope in self.stack.iter().rev() {
            if scope.names.contains_key(&text) {
                return false;
            }
            if scope.boundary == Boundary::Branch {
                return true;
            }
        }
        false
    }

    /// Whether a `break` here would leave a data-dependent branch. A label could lead anywhere.
    pub(crate) fn break_leaves_branch(&self, labelled: bool) -> bool {
        for scope in self.stack.iter().rev() {
            match scope.boundary {
                Boundary::Branch => return true,
                Boundary::Loop if !labelled => return false,
                _ => {}
            }
        }
        false
    }
}

struct Names(Vec<Ident>);

impl<'ast> syn::visit::Visit<'ast> for Names {
    fn visit_pat_ident(&mut self, pattern: &'ast syn::PatIdent) {
        self.0.push(pattern.ident.clone());
        syn::visit::visit_pat_ident(self, pattern);
    }
}
