//! The one table of diagnostic codes and their long texts (`sml explain CODE`).

use std::fmt;

macro_rules! codes {
    ($($variant:ident = $number:literal, $title:literal, $text:literal;)*) => {
        /// A stable diagnostic code; printed as `SML0007`.
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
        pub enum Code {
            $(#[doc = $title] $variant = $number,)*
        }

        impl Code {
            /// Every code, in order.
            pub const ALL: &'static [Code] = &[$(Code::$variant),*];

            /// A few words: what this code is about.
            pub fn title(self) -> &'static str {
                match self { $(Code::$variant => $title,)* }
            }

            /// The long text: what is wrong, why it is refused, how to mend it.
            pub fn explanation(self) -> &'static str {
                match self { $(Code::$variant => $text,)* }
            }
        }
    };
}

impl fmt::Display for Code {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "SML{:04}", *self as u16)
    }
}

// 1 to 19: lexis and syntax; 20 to 49: names and types; 50 to 69: play-out; 70 to 89: the game; 90 up: warnings.
codes! {
    Lexical = 1, "text that is not a token",
        "The text contains a character or an unfinished token that SML does not know.\n";
}
