//! What generated modules leave to the features of this crate: they cannot know which are on, and a `cfg` of theirs would
//! ask for the features of the crate that they are in.

/// Keeps the items with feature `names`, drops them without.
#[cfg(feature = "names")]
#[doc(hidden)]
#[macro_export]
macro_rules! names {
    ($($item:item)*) => { $($item)* };
}

/// Keeps the items with feature `names`, drops them without.
#[cfg(not(feature = "names"))]
#[doc(hidden)]
#[macro_export]
macro_rules! names {
    ($($item:item)*) => {};
}

/// Derives `defmt::Format` for the items with feature `defmt`.
#[cfg(feature = "defmt")]
#[doc(hidden)]
#[macro_export]
macro_rules! formatted {
    ($($item:item)*) => {
        $(
            #[derive($crate::defmt::Format)]
            #[defmt(crate = $crate::defmt)]
            $item
        )*
    };
}

/// Derives `defmt::Format` for the items with feature `defmt`.
#[cfg(not(feature = "defmt"))]
#[doc(hidden)]
#[macro_export]
macro_rules! formatted {
    ($($item:item)*) => { $($item)* };
}

/// Serialises types by their texts, and a set of such types by its fields, with feature `serde`.
#[cfg(feature = "serde")]
#[doc(hidden)]
#[macro_export]
macro_rules! serialized {
    (struct Commands { $($field:ident: $command:ident,)* } $(struct $type:ident;)*) => {
        $(
            impl $crate::serde::Serialize for $type {
                fn serialize<S: $crate::serde::Serializer>(
                    &self,
                    serializer: S,
                ) -> ::core::result::Result<S::Ok, S::Error> {
                    serializer.serialize_str(self.text())
                }
            }

            impl<'de> $crate::serde::Deserialize<'de> for $type {
                fn deserialize<D: $crate::serde::Deserializer<'de>>(
                    deserializer: D,
                ) -> ::core::result::Result<Self, D::Error> {
                    $crate::from_text(deserializer, Self::from_text)
                }
            }
        )*

        const _: () = {
            #[derive($crate::serde::Serialize, $crate::serde::Deserialize)]
            #[serde(crate = "::controller_template::serde", remote = "Commands", deny_unknown_fields)]
            struct Fields {
                $($field: ::core::option::Option<$command>,)*
            }

            impl $crate::serde::Serialize for Commands {
                fn serialize<S: $crate::serde::Serializer>(
                    &self,
                    serializer: S,
                ) -> ::core::result::Result<S::Ok, S::Error> {
                    Fields::serialize(self, serializer)
                }
            }

            impl<'de> $crate::serde::Deserialize<'de> for Commands {
                fn deserialize<D: $crate::serde::Deserializer<'de>>(
                    deserializer: D,
                ) -> ::core::result::Result<Self, D::Error> {
                    Fields::deserialize(deserializer)
                }
            }
        };
    };
}

/// Serialises types by their texts, and a set of such types by its fields, with feature `serde`.
#[cfg(not(feature = "serde"))]
#[doc(hidden)]
#[macro_export]
macro_rules! serialized {
    (struct Commands { $($field:ident: $command:ident,)* } $(struct $type:ident;)*) => {};
}
