//! Random sentences of the whole grammar: they can be read, whatever they mean.
//!
//! Every construct of the language reference occurs, older spellings, optional separators and comments included.
//! Names are not declared and types do not fit.

use super::Random;

/// A sentence of the grammar; the same for the same seed.
#[must_use]
pub fn sentence(seed: u64) -> String {
    let mut writer = Writer { random: Random::new(seed), text: String::new(), requirements: 0 };
    writer.file();
    writer.text
}

/// Names, among them words that only continue a construct and keywords of Rust.
const NAMES: [&str; 16] = [
    "a",
    "b2",
    "Arm",
    "feed_belt",
    "X",
    "over",
    "to",
    "events",
    "ranges",
    "message",
    "move",
    "type",
    "until",
    "sender",
    "system",
    "with",
];

/// What may stand between two tokens.
const GAPS: [(usize, &str); 7] = [
    (60, " "),
    (10, "\n"),
    (3, "\t "),
    (2, " // a comment {\n"),
    (2, " /* a /* nested */ } */ "),
    (1, "\r\n"),
    (1, " //! not kept\n"),
];

struct Writer {
    random: Random,
    text: String,
    requirements: usize,
}

impl Writer {
    /// A token and a gap behind it.
    fn put(&mut self, token: &str) {
        self.text.push_str(token);
        let gap = self.random.weighted(&GAPS);
        self.text.push_str(gap);
    }

    fn all(&mut self, tokens: &str) {
        tokens.split(' ').for_each(|token| self.put(token));
    }

    fn maybe(&mut self, percent: usize, tokens: &str) {
        if self.random.chance(percent) {
            self.all(tokens);
        }
    }

    fn name(&mut self) {
        let name = *self.random.pick(&NAMES);
        self.put(name);
    }

    /// A name that no older spelling can be mistaken for.
    fn plain_name(&mut self) {
        let name = *self.random.pick(&NAMES[..5]);
        self.put(name);
    }

    /// So many items, fewer more often.
    fn many(&mut self, least: usize, item: impl Fn(&mut Self)) {
        let count = least + self.random.below(3).min(self.random.below(3));
        (0..count).for_each(|_| item(self));
    }

    /// Items, each with an optional separator behind it.
    fn list(&mut self, least: usize, item: impl Fn(&mut Self)) {
        self.many(least, |writer| {
            item(writer);
            let separator = writer.random.weighted(&[(6, ""), (1, ","), (1, ";")]);
            writer.maybe(if separator.is_empty() { 0 } else { 100 }, separator);
        });
    }

    /// Items with commas between them and perhaps one behind the last.
    fn commas(&mut self, least: usize, item: impl Fn(&mut Self)) {
        let count = least + self.random.below(3);
        for index in 0..count {
            item(self);
            let last = index + 1 == count;
            self.maybe(if last { 20 } else { 100 }, ",");
        }
    }

    fn file(&mut self) {
        self.many(0, |writer| {
            writer.all("import \"../a\\\\b.sml\"");
            writer.maybe(30, ";");
        });
        self.maybe(10, "system");
        self.put("specification");
        self.name();
        self.put("{");
        self.many(2, |writer| {
            writer.section();
            writer.maybe(20, ";");
        });
        self.all("}");
        self.maybe(10, ";");
    }

    fn section(&mut self) {
        match self.random.below(10) {
            0 | 1 => self.domain(),
            2 => self.object(),
            3 => {
                self.all("effects {");
                self.list(0, Self::effect);
                self.put("}");
            }
            4 => {
                self.all("controllable {");
                self.list(0, Self::name);
                self.put("}");
            }
            5 => {
                self.all("non - spontaneous events {");
                self.list(0, Self::event);
                self.put("}");
            }
            6 => {
                self.all("parameter ranges {");
                self.list(0, Self::ranges);
                self.put("}");
            }
            7 => {
                self.all("channels {");
                self.list(0, |writer| {
                    writer.event();
                    writer.put("over");
                    writer.event();
                });
                self.put("}");
            }
            _ => self.collaboration(),
        }
    }

    fn domain(&mut self) {
        self.put("domain");
        if self.random.chance(60) {
            self.name();
        }
        self.put("{");
        self.list(1, |writer| {
            if writer.random.chance(30) {
                writer.put("enum");
                writer.name();
                writer.put("{");
                writer.commas(1, Self::name);
            } else {
                writer.maybe(20, "abstract");
                writer.put("class");
                writer.name();
                if writer.random.chance(30) {
                    writer.put(":");
                    writer.name();
                }
                writer.put("{");
                writer.list(0, Self::member);
            }
            writer.put("}");
        });
        self.put("}");
    }

    fn member(&mut self) {
        self.name();
        if self.random.chance(50) {
            self.put(":");
            self.ty();
            if self.random.chance(40) {
                self.put("=");
                self.literal();
            }
            return;
        }
        self.put("(");
        self.commas(0, |writer| {
            writer.name();
            writer.put(":");
            writer.ty();
        });
        self.put(")");
    }

    fn ty(&mut self) {
        match self.random.below(3) {
            0 => self.put("bool"),
            1 => {
                self.integer();
                self.put("..=");
                self.integer();
            }
            _ => self.name(),
        }
    }

    fn integer(&mut self) {
        let number = *self.random.pick(&["0", "1", "42", "007", "9223372036854775807", "-1", "- 3"]);
        self.put(number);
    }

    fn literal(&mut self) {
        match self.random.below(6) {
            0 => self.put("true"),
            1 => self.put("false"),
            2 => self.put("null"),
            3 => self.integer(),
            4 => self.name(),
            _ => {
                self.name();
                self.put(":");
                self.name();
            }
        }
    }

    fn object(&mut self) {
        self.put("object");
        self.name();
        self.put(":");
        self.name();
        if self.random.chance(50) {
            self.put("{");
            self.list(0, |writer| {
                writer.name();
                writer.put(":");
                writer.literal();
            });
            self.put("}");
        }
    }

    fn event(&mut self) {
        self.name();
        self.put(".");
        self.name();
    }

    fn effect(&mut self) {
        self.name();
        self.put("->");
        self.event();
        self.put("(");
        self.commas(0, Self::name);
        self.all(") {");
        self.many(0, |writer| {
            writer.path();
            writer.put("=");
            // Otherwise the next assignment could be read as a part of this value.
            writer.expr(2);
            writer.put(";");
        });
        self.put("}");
    }

    fn ranges(&mut self) {
        self.event();
        self.put("(");
        self.list(1, |writer| {
            writer.name();
            writer.all("= [");
            writer.commas(1, |writer| {
                if writer.random.chance(50) {
                    return writer.literal();
                }
                writer.integer();
                let dots = *writer.random.pick(&["..", "..="]);
                writer.put(dots);
                writer.integer();
            });
            writer.put("]");
        });
        self.put(")");
    }

    fn collaboration(&mut self) {
        self.put("collaboration");
        self.name();
        self.put("{");
        self.list(0, |writer| {
            let kind = *writer.random.pick(&["static", "dynamic"]);
            writer.put(kind);
            writer.put("role");
            writer.name();
            writer.name();
        });
        self.list(1, Self::scenario);
        self.put("}");
    }

    fn scenario(&mut self) {
        if self.random.chance(40) {
            self.requirements += 1;
            let line = format!(
                "\n/// requirement {}: 'quoted' \"text\" \\ {{ € \n///\n///   indented\n",
                self.requirements
            );
            self.text.push_str(&line);
        }
        let kind =
            *self.random.pick(&["assumption", "guarantee", "existential", "specification", "requirement"]);
        self.put(kind);
        self.put("scenario");
        self.plain_name();
        match self.random.below(6) {
            0 => {
                self.all("bindings [");
                self.many(0, |writer| {
                    writer.name();
                    writer.put("=");
                    writer.expr(1);
                    writer.put(",");
                });
                self.put("]");
            }
            1 => {
                self.all("with dynamic bindings [");
                self.many(0, |writer| {
                    writer.put("bind");
                    writer.name();
                    writer.put("to");
                    writer.expr(1);
                    writer.put(",");
                });
                self.put("]");
            }
            _ => {}
        }
        self.body(3);
    }

    fn body(&mut self, depth: usize) {
        self.put("{");
        self.many(0, |writer| {
            writer.fragment(depth);
            // Behind an expression the next fragment could be read as its continuation.
            writer.put(";");
        });
        self.put("}");
        if self.random.chance(20) {
            self.all("constraints [");
            self.list(0, |writer| {
                let kind = *writer.random.pick(&["forbidden", "ignore", "interrupt", "consider"]);
                writer.put(kind);
                writer.maybe(10, "message");
                writer.message();
            });
            self.put("]");
        }
    }

    fn fragment(&mut self, depth: usize) {
        let nested = if depth == 0 { 0 } else { 1 };
        match self.random.weighted(&[
            (10, 0),
            (2, 1),
            (2, 2),
            (2, 3),
            (2, 4),
            (2 * nested, 5),
            (2 * nested, 6),
            (2 * nested, 7),
            (nested, 8),
        ]) {
            0 => {
                self.maybe(10, "message");
                self.modifier();
                self.message();
            }
            1 => {
                self.put("wait");
                let until = self.random.below(8);
                self.maybe(if until == 0 { 100 } else { 0 }, "until");
                self.maybe(30, "strict");
                self.maybe(30, "eventually");
                self.maybe(if until == 1 { 100 } else { 0 }, "until");
                self.condition();
            }
            2 => {
                let word = *self.random.pick(&["interrupt", "violation"]);
                self.put(word);
                self.maybe(20, "if");
                self.condition();
            }
            3 => {
                self.put("var");
                self.ty();
                self.name();
                if self.random.chance(60) {
                    self.put("=");
                    self.expr(2);
                }
            }
            4 => {
                self.plain_name();
                self.put("=");
                self.expr(2);
            }
            5 => self.cases("alternative", "or", true, depth - 1),
            6 => self.cases("parallel", "and", false, depth - 1),
            7 => self.cases("while", "", true, depth - 1),
            _ => self.body(depth - 1),
        }
    }

    fn cases(&mut self, first: &str, next: &str, conditions: bool, depth: usize) {
        let count = if next.is_empty() { 1 } else { 1 + self.random.below(3) };
        for index in 0..count {
            self.put(if index == 0 { first } else { next });
            if conditions && self.random.chance(50) {
                self.condition();
            }
            self.body(depth);
        }
    }

    fn modifier(&mut self) {
        self.maybe(30, "strict");
        if self.random.chance(60) {
            self.maybe(20, "monitored");
            let modality = *self.random.pick(&["eventually", "urgent", "requested", "committed"]);
            self.put(modality);
        }
    }

    fn message(&mut self) {
        self.plain_name();
        self.put("->");
        self.event();
        if self.random.chance(30) {
            return;
        }
        self.put("(");
        self.commas(0, |writer| match writer.random.below(4) {
            0 => writer.put("*"),
            1 => {
                writer.put("bind");
                writer.maybe(40, "to");
                writer.plain_name();
            }
            _ => writer.expr(2),
        });
        self.put(")");
    }

    fn condition(&mut self) {
        self.put("[");
        self.expr(3);
        self.put("]");
    }

    fn path(&mut self) {
        self.name();
        self.many(0, |writer| {
            writer.put(".");
            writer.name();
        });
    }

    fn expr(&mut self, depth: usize) {
        let nested = if depth == 0 { 0 } else { 1 };
        match self.random.weighted(&[(4, 0), (2, 1), (6 * nested, 2), (3 * nested, 3), (3 * nested, 4)]) {
            0 => self.path(),
            1 => self.literal(),
            2 => {
                let operators = ["=>", "||", "&&", "+", "-", "*"];
                self.operand(depth - 1);
                let operator = *self.random.pick(&operators);
                self.put(operator);
                self.expr(depth - 1);
            }
            3 => {
                let operators = ["==", "!=", "<", "<=", ">", ">="];
                self.operand(depth - 1);
                let operator = *self.random.pick(&operators);
                self.put(operator);
                self.operand(depth - 1);
            }
            _ => {
                let sign = *self.random.pick(&["!", "-"]);
                self.put(sign);
                self.operand(depth - 1);
            }
        }
    }

    /// An expression that stands alone: comparisons do not chain.
    fn operand(&mut self, depth: usize) {
        if self.random.chance(40) {
            return self.path();
        }
        self.put("(");
        self.expr(depth);
        self.put(")");
    }
}
