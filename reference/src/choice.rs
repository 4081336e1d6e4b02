//! Choices by name: what a scene or a command line picks one of.

/// A name that is none of a choice's names.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("there is no {what} `{given}`; choose one of {}", allowed.join(", "))]
pub struct UnknownName {
    /// What was to be chosen.
    pub what: &'static str,
    /// What was given.
    pub given: String,
    /// What there is.
    pub allowed: Vec<&'static str>,
}

/// Declares an enum whose variants have names that users write, upper and lower case alike: `ALL`, `name()`, conversion from
/// and to text and through serde by that name, where a wrong name is an [`UnknownName`] that lists the right ones.
///
/// ```
/// etalon_reference::choice! {
///     /// How to order eggs.
///     Eggs, "egg" {
///         /// Four minutes.
///         Soft = "soft",
///         /// Ten minutes.
///         Hard = "hard",
///     }
/// }
/// assert_eq!("Hard".parse(), Ok(Eggs::Hard));
/// assert_eq!("raw".parse::<Eggs>().unwrap_err().to_string(), "there is no egg `raw`; choose one of soft, hard");
/// ```
#[macro_export]
macro_rules! choice {
    ($(#[$meta:meta])* $type:ident, $what:literal { $($(#[$variant_meta:meta])* $variant:ident = $name:literal,)* }) => {
        $(#[$meta])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum $type { $($(#[$variant_meta])* $variant,)* }
        impl $type {
            /// Every choice there is.
            pub const ALL: &'static [$type] = &[$($type::$variant),*];
            /// The name users write.
            pub fn name(self) -> &'static str {
                match self { $($type::$variant => $name),* }
            }
        }
        impl ::std::fmt::Display for $type {
            fn fmt(&self, f: &mut ::std::fmt::Formatter<'_>) -> ::std::fmt::Result {
                f.pad(self.name())
            }
        }
        impl ::serde::Serialize for $type {
            fn serialize<S: ::serde::Serializer>(&self, serializer: S) -> ::std::result::Result<S::Ok, S::Error> {
                serializer.serialize_str(self.name())
            }
        }
        impl<'de> ::serde::Deserialize<'de> for $type {
            fn deserialize<D: ::serde::Deserializer<'de>>(deserializer: D) -> ::std::result::Result<Self, D::Error> {
                let name = <::std::string::String as ::serde::Deserialize>::deserialize(deserializer)?;
                name.parse().map_err(::serde::de::Error::custom)
            }
        }
        impl ::std::str::FromStr for $type {
            type Err = $crate::choice::UnknownName;
            fn from_str(given: &str) -> ::std::result::Result<Self, Self::Err> {
                Self::ALL.iter().copied().find(|c| c.name().eq_ignore_ascii_case(given)).ok_or_else(|| $crate::choice::UnknownName {
                    what: $what,
                    given: given.to_string(),
                    allowed: Self::ALL.iter().map(|c| c.name()).collect(),
                })
            }
        }
    };
}
