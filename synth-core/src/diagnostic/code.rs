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
        "The text contains a character that begins no token. SML uses the tokens of Rust, so that the same text can\n\
         stand in a file and in a macro; characters outside ASCII, `\\`, a backtick and single quotes occur only in\n\
         comments and in the strings of imports. Raw strings and raw identifiers do not exist.\n\n\
         Wrong:  class Price { value: 0..=9 € }\n\
         Right:  class Price { value: 0..=9 }\n";
    Delimiter = 2, "delimiter without its partner",
        "A `{`, `[` or `(` is never closed, or a closing one closes nothing or stands where another is due. When the\n\
         partner is missing at the end of the text, the indentation of the lines decides which opening one is shown:\n\
         the first whose supposed partner stands further to the left. Nothing behind this place can be read reliably,\n\
         so further mistakes there show only when it is mended.\n\n\
         Wrong:  wait [arm.free\n\
         Right:  wait [arm.free]\n";
    Unterminated = 3, "string or comment without its end",
        "A string ends with `\"` on the line where it begins, a block comment with `*/`; block comments nest, so each\n\
         `/*` inside one needs a `*/` of its own. All text behind an unfinished one belongs to it.\n\n\
         Wrong:  import \"cell.sml\n\
         Right:  import \"cell.sml\"\n";
    Syntax = 4, "token out of place",
        "The tokens are SML's own, but not in an order that the grammar knows; the message says what could stand at\n\
         this place. Arguments, parameters and enum literals are separated by `,`; a `;` may end any fragment,\n\
         declaration or effect assignment. The reader goes on behind the construct, so one run shows several mistakes.\n\n\
         Wrong:  eventually controller arm.pickUp()\n\
         Right:  eventually controller -> arm.pickUp()\n";
    Reserved = 5, "keyword used as a name",
        "Words that open or modify a construct of SML are not names: the reader could not tell one from the other.\n\
         The keywords of Rust are free: an operation may be called `move` and an attribute `type`.\n\n\
         Wrong:  class Belt { wait() }\n\
         Right:  class Belt { waitForBlank() }\n";
    NameForm = 6, "name of a form that SML does not allow",
        "A name is a letter followed by letters, digits and `_`, all of them ASCII: names go into Rust and into the\n\
         languages of programmable controllers, which allow no more than that.\n\n\
         Wrong:  object _türe: Door\n\
         Right:  object tuere: Door\n";
    NumberForm = 7, "number that is not a plain decimal integer",
        "Integers are written with decimal digits alone: no other base, no `_` between digits, no suffix, no fraction\n\
         and no exponent. The two ends of a range have two dots between them.\n\n\
         Wrong:  level: 0..=0x10\n\
         Right:  level: 0..=16\n";
    NumberRange = 8, "integer beyond 64 bits",
        "Integers lie between -9223372036854775808 and 9223372036854775807, and so does all arithmetic. Ranges of\n\
         attributes and parameters should be far smaller, since every value can be a state of its own.\n\n\
         Wrong:  count: 0..=99999999999999999999\n\
         Right:  count: 0..=99\n";
    OldType = 9, "type of an older dialect",
        "`EBoolean`, `EInt` and `EString` belong to specifications over an Ecore model. A finite game needs finite\n\
         types: `bool`, a range of integers, an enum, or a class.\n\n\
         Wrong:  var EInt floor\n\
         Right:  var 1..=3 floor\n";
    Empty = 10, "no specification in the text",
        "A file holds imports and then exactly one specification; this one holds nothing but space and comments.\n\n\
         Right:  specification Name { … }\n";
    TooDeep = 11, "nesting too deep",
        "Braces, brackets, parentheses and expressions nest up to a fixed depth that no specification written by hand\n\
         comes near, so that a broken generator cannot exhaust the stack. Give a part of the expression a variable of\n\
         its own, or split the scenario.\n\n\
         Wrong:  wait [((((…((((a))))…))))]\n\
         Right:  wait [a]\n";
    Encoding = 12, "file that is not UTF-8",
        "Specifications are UTF-8 text, with or without a byte order mark. Open the file in an editor with its real\n\
         encoding, often Latin-1 or UTF-16, and store it again as UTF-8.\n";
    ComparisonChain = 13, "comparisons in a chain",
        "Comparisons do not chain: `a < b < c` would compare a truth value with `c`. Say which comparisons are meant,\n\
         or put the inner one in parentheses.\n\n\
         Wrong:  wait [1 < lift.level < 3]\n\
         Right:  wait [1 < lift.level && lift.level < 3]\n";
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_code_is_explained() {
        for pair in Code::ALL.windows(2) {
            assert!((pair[0] as u16) < pair[1] as u16, "{} is out of order", pair[1]);
        }
        for code in Code::ALL {
            assert!(!code.title().ends_with('.'), "{code}");
            assert!(code.explanation().ends_with('\n'), "{code}");
            assert!(code.explanation().len() > 100, "{code}");
        }
    }

    #[test]
    fn codes_have_four_digits() {
        assert_eq!(Code::Lexical.to_string(), "SML0001");
    }
}
