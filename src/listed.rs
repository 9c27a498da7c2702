//! Enums that know all their variants, so that no list of them can miss one.

/// Declares an enum without fields, and `ALL`, its variants in the order of their declaration.
macro_rules! listed {
    ($(#[$meta:meta])* pub enum $name:ident { $( $(#[$about:meta])* $variant:ident, )+ }) => {
        $(#[$meta])*
        pub enum $name { $( $(#[$about])* $variant, )+ }

        impl $name {
            /// All of them, in order.
            pub const ALL: [Self; [$( stringify!($variant) ),+].len()] = [$( Self::$variant ),+];
        }
    };
}

pub(crate) use listed;
