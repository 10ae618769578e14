//! Expressions, paths and literals.

use syn::Token;
use syn::parse::ParseStream;

use super::reader::{Reader, Result};
use crate::diagnostic::{Code, Diagnostic};
use crate::syntax::Span;
use crate::syntax::ast::{BinaryOp, Expr, ExprKind, Name, Path, UnaryOp};

/// How high the tree of an expression may grow: chains of operators are read by a loop, but walked by recursion.
const MAX_HEIGHT: usize = 512;

/// An expression on its way into a larger one.
struct Operand {
    expr: Expr,
    /// With the parentheses around it.
    extent: Span,
    height: usize,
}

impl Operand {
    fn leaf(expr: Expr) -> Operand {
        Operand { extent: expr.span, expr, height: 1 }
    }
}

impl Reader {
    pub(super) fn expr(&self, input: ParseStream<'_>) -> Result<Expr> {
        Ok(self.binary(input, 0)?.expr)
    }

    /// An expression of operators that bind at least as tightly as `least`.
    fn binary(&self, input: ParseStream<'_>, least: u8) -> Result<Operand> {
        let mut left = self.unary(input)?;
        let mut comparison = None;
        if let Some(error) = self.no_operator(input) {
            return Err(error);
        }
        while let Some(op) = peek_operator(input).filter(|op| op.precedence() >= least) {
            let at = self.operator_span(input, op);
            if op.precedence() == COMPARISON
                && let Some(first) = comparison.replace(at)
            {
                return Err(chain(first, at));
            }
            for _ in op.text().chars() {
                self.skip(input);
            }
            let tighter = op.precedence() + u8::from(op != BinaryOp::Implies);
            let right = self.nested(input, || self.binary(input, tighter))?;
            if op.precedence() != COMPARISON {
                comparison = None;
            }
            let height = left.height.max(right.height) + 1;
            if height > MAX_HEIGHT {
                let error = Diagnostic::error(Code::TooDeep, at, "too many operators in one expression");
                return Err(Box::new(error.note(format!("at most {MAX_HEIGHT} are read"))));
            }
            let extent = left.extent.to(right.extent);
            let kind = ExprKind::Binary(op, Box::new(left.expr), Box::new(right.expr));
            left = Operand { expr: Expr { kind, span: extent }, extent, height };
        }
        Ok(left)
    }

    /// The error that an operand is followed by an operator of another language.
    fn no_operator(&self, input: ParseStream<'_>) -> Option<Box<Diagnostic>> {
        let (found, meant) = self.foreign_operator(input)?;
        let mut span = self.span(input);
        span.end.column = span.start.column + found.len() as u32;
        let error = Diagnostic::error(Code::Syntax, span, format!("`{found}` is no operator of expressions"));
        Some(Box::new(error.help(format!("write `{meant}` instead of `{found}`"))))
    }

    fn operator_span(&self, input: ParseStream<'_>, op: BinaryOp) -> Span {
        let mut span = self.span(input);
        span.end.column = span.start.column + op.text().len() as u32;
        span
    }

    fn unary(&self, input: ParseStream<'_>) -> Result<Operand> {
        let start = self.span(input);
        let op = if input.peek(Token![!]) && !input.peek(Token![!=]) {
            UnaryOp::Not
        } else if input.peek(Token![-]) && !input.peek(Token![->]) {
            if let Some(value) = self.integer(input)? {
                let span = self.since(start, input);
                return Ok(Operand::leaf(Expr { kind: ExprKind::Int(value), span }));
            }
            UnaryOp::Neg
        } else {
            return self.primary(input);
        };
        self.skip(input);
        let operand = self.nested(input, || self.unary(input))?;
        let span = start.to(operand.extent);
        let kind = ExprKind::Unary(op, Box::new(operand.expr));
        Ok(Operand { expr: Expr { kind, span }, extent: span, height: operand.height + 1 })
    }

    fn primary(&self, input: ParseStream<'_>) -> Result<Operand> {
        if input.peek(syn::token::Paren) {
            let (inner, extent) = self.parens(input, "`(`", |inside| self.binary(inside, 0))?;
            return Ok(Operand { extent, ..inner });
        }
        let start = self.span(input);
        let literal = self.simple(input, "an expression")?;
        let ExprKind::Path(mut path) = literal.kind else { return Ok(Operand::leaf(literal)) };
        if path.names[0].text == "not" && self.at_operand(input) {
            let error = Diagnostic::error(Code::Syntax, start, "`not` is no operator of expressions");
            return Err(Box::new(error.help("write `!` instead of `not`")));
        }
        self.path_rest(input, &mut path)?;
        let span = path.span;
        Ok(Operand::leaf(Expr { kind: ExprKind::Path(path), span }))
    }

    /// Whether an operand begins here, where none can stand behind a name.
    fn at_operand(&self, input: ParseStream<'_>) -> bool {
        input.peek(syn::token::Paren)
            || self.word(input).is_some_and(|word| !self.is_reserved(&word))
                && !input.peek2(Token![->])
                && (input.peek2(Token![==]) || !input.peek2(Token![=]))
    }

    /// `true | false | int | null | ID | ID : ID`.
    pub(super) fn literal(&self, input: ParseStream<'_>) -> Result<Expr> {
        let literal = self.simple(input, "a literal")?;
        if input.peek(Token![.]) && !input.peek(Token![..]) {
            let error = self.expected(input, "the end of the literal");
            return Err(Box::new(error.note("only literals can stand here, no paths")));
        }
        Ok(literal)
    }

    fn simple(&self, input: ParseStream<'_>, what: &str) -> Result<Expr> {
        let span = self.span(input);
        if let Some(value) = self.integer(input)? {
            return Ok(Expr { kind: ExprKind::Int(value), span: self.since(span, input) });
        }
        let kind = match self.word(input).as_deref() {
            Some("true") => ExprKind::Bool(true),
            Some("false") => ExprKind::Bool(false),
            Some("null") => ExprKind::Null,
            _ => return self.named(input, what),
        };
        self.skip(input);
        Ok(Expr { kind, span })
    }

    fn named(&self, input: ParseStream<'_>, what: &str) -> Result<Expr> {
        let name = self.name(input, what)?;
        if self.eat_punct(input, Token![:]) {
            let literal = self.name(input, "a literal of the enum")?;
            let span = name.span.to(literal.span);
            return Ok(Expr { kind: ExprKind::Literal(name, literal), span });
        }
        let span = name.span;
        Ok(Expr { kind: ExprKind::Path(Path { names: vec![name], span }), span })
    }

    /// `ID (. ID)*`.
    pub(super) fn path(&self, input: ParseStream<'_>, what: &str) -> Result<Path> {
        let first: Name = self.name(input, what)?;
        let mut path = Path { span: first.span, names: vec![first] };
        self.path_rest(input, &mut path)?;
        Ok(path)
    }

    fn path_rest(&self, input: ParseStream<'_>, path: &mut Path) -> Result<()> {
        while self.eat_punct(input, Token![.]) {
            let name = self.name(input, "the name of an attribute")?;
            path.span = path.span.to(name.span);
            path.names.push(name);
        }
        Ok(())
    }

    /// `INT | - INT`; takes nothing if neither comes next.
    pub(crate) fn integer(&self, input: ParseStream<'_>) -> Result<Option<i64>> {
        let start = self.span(input);
        let negative = input.peek(Token![-]);
        if negative {
            let number = input.cursor().punct().and_then(|(_, rest)| rest.literal());
            if !number.is_some_and(|(number, _)| number.to_string().starts_with(|c: char| c.is_ascii_digit()))
            {
                return Ok(None);
            }
            self.skip(input);
        }
        let Some(digits) = self.digits(input)? else { return Ok(None) };
        let text = if negative { format!("-{digits}") } else { digits };
        match text.parse() {
            Ok(value) => Ok(Some(value)),
            Err(_) => {
                let message = format!("`{text}` is no 64-bit integer");
                let error = Diagnostic::error(Code::NumberRange, self.since(start, input), message);
                Err(Box::new(error.note(format!("integers lie between {} and {}", i64::MIN, i64::MAX))))
            }
        }
    }
}

/// The precedence of comparisons, which do not chain.
const COMPARISON: u8 = 4;

impl BinaryOp {
    /// How tightly it binds.
    pub(in crate::syntax) fn precedence(self) -> u8 {
        match self {
            BinaryOp::Implies => 1,
            BinaryOp::Or => 2,
            BinaryOp::And => 3,
            BinaryOp::Eq | BinaryOp::Ne | BinaryOp::Lt | BinaryOp::Le | BinaryOp::Gt | BinaryOp::Ge => {
                COMPARISON
            }
            BinaryOp::Add | BinaryOp::Sub => 5,
            BinaryOp::Mul => 6,
        }
    }

    /// As it is written.
    pub(in crate::syntax) fn text(self) -> &'static str {
        match self {
            BinaryOp::Implies => "=>",
            BinaryOp::Or => "||",
            BinaryOp::And => "&&",
            BinaryOp::Eq => "==",
            BinaryOp::Ne => "!=",
            BinaryOp::Lt => "<",
            BinaryOp::Le => "<=",
            BinaryOp::Gt => ">",
            BinaryOp::Ge => ">=",
            BinaryOp::Add => "+",
            BinaryOp::Sub => "-",
            BinaryOp::Mul => "*",
        }
    }
}

/// Longer operators first: `=>` and `==` begin with `=`, `->` with `-`.
fn peek_operator(input: ParseStream<'_>) -> Option<BinaryOp> {
    Some(match () {
        () if input.peek(Token![=>]) => BinaryOp::Implies,
        () if input.peek(Token![||]) => BinaryOp::Or,
        () if input.peek(Token![&&]) => BinaryOp::And,
        () if input.peek(Token![==]) => BinaryOp::Eq,
        () if input.peek(Token![!=]) => BinaryOp::Ne,
        () if input.peek(Token![<=]) => BinaryOp::Le,
        () if input.peek(Token![>=]) => BinaryOp::Ge,
        () if input.peek(Token![->]) => return None,
        () if input.peek(Token![<]) => BinaryOp::Lt,
        () if input.peek(Token![>]) => BinaryOp::Gt,
        () if input.peek(Token![+]) => BinaryOp::Add,
        () if input.peek(Token![-]) => BinaryOp::Sub,
        () if input.peek(Token![*]) => BinaryOp::Mul,
        () => return None,
    })
}

fn chain(first: Span, second: Span) -> Box<Diagnostic> {
    let error = Diagnostic::error(Code::ComparisonChain, second, "comparisons do not chain")
        .also(first, "the first comparison");
    Box::new(error.help("join two comparisons with `&&`, or put one into parentheses"))
}
