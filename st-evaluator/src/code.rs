//! The form that runs: names are places, types are known, constants are folded.

use crate::error::Position;
use crate::kind::Kind;

/// Where a value is. Memory is cells; a place is the address of the first one.
#[derive(Clone, Debug)]
pub(crate) enum Place {
    /// In the table of constants.
    Constant(u32),
    /// Among the global variables.
    Global(u32),
    /// In the instance of a function block or program.
    This(u32),
    /// In the frame of a call.
    Frame(u32),
    /// At the address that a cell of the instance holds (`VAR_IN_OUT`).
    ThroughThis(u32),
    /// At the address that a cell of the frame holds (`VAR_IN_OUT`).
    ThroughFrame(u32),
    Field(Box<Place>, u32),
    Element(Box<Element>),
    /// What a pointer points to.
    Target(Box<Target>),
}

#[derive(Clone, Debug)]
pub(crate) struct Element {
    pub(crate) base: Place,
    pub(crate) index: Expr,
    pub(crate) low: i64,
    pub(crate) high: i64,
    /// In cells.
    pub(crate) stride: u32,
    pub(crate) at: Position,
}

#[derive(Clone, Debug)]
pub(crate) struct Target {
    pub(crate) pointer: Expr,
    /// `p[i]`: how many values of the size further on.
    pub(crate) index: Option<Expr>,
    /// In cells; what lies behind must be so many. 0 if elements are checked one by one.
    pub(crate) size: u32,
    pub(crate) at: Position,
}

#[derive(Clone, Debug)]
pub(crate) enum Expr {
    Value(i64),
    Load(Place),
    Unary(Unary, Kind, Box<Expr>),
    Binary(Box<Binary>),
    /// `AND_THEN` (true) and `OR_ELSE` (false).
    Shortcut(bool, Box<(Expr, Expr)>),
    Convert {
        from: Kind,
        to: Kind,
        value: Box<Expr>,
    },
    /// A value for a subrange.
    Within(Box<Within>),
    /// The smallest (true) or largest of several.
    Extreme(bool, Kind, Vec<Expr>),
    /// `SEL` and `MUX`: the first is the number of the other one.
    Select(Vec<Expr>, Position),
    Call(Box<Call>),
    /// `ADR` of a place and its size.
    Address(Box<Place>, u32),
    /// `LEN`.
    Length(Box<Text>),
    CompareTexts(Operator, Box<(Text, Text)>),
    /// `STRING_TO_…`.
    Number(Box<Text>, Kind, Position),
    Clock,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Unary {
    Negate,
    Complement,
    Absolute,
}

#[derive(Clone, Debug)]
pub(crate) struct Binary {
    pub(crate) operator: Operator,
    /// Of both operands; of the left one in shifts.
    pub(crate) kind: Kind,
    pub(crate) left: Expr,
    pub(crate) right: Expr,
    pub(crate) at: Position,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Operator {
    Add,
    Subtract,
    Multiply,
    Divide,
    Modulo,
    And,
    Or,
    Xor,
    Equal,
    Unequal,
    Less,
    LessOrEqual,
    Greater,
    GreaterOrEqual,
    ShiftLeft,
    ShiftRight,
    RotateLeft,
    RotateRight,
}

impl Operator {
    pub(crate) fn is_comparison(self) -> bool {
        use Operator::{Equal, Greater, GreaterOrEqual, Less, LessOrEqual, Unequal};
        matches!(self, Equal | Unequal | Less | LessOrEqual | Greater | GreaterOrEqual)
    }
}

#[derive(Clone, Debug)]
pub(crate) struct Within {
    pub(crate) value: Expr,
    pub(crate) low: i64,
    pub(crate) high: i64,
    pub(crate) at: Position,
}

/// A string.
#[derive(Clone, Debug)]
pub(crate) enum Text {
    Literal(Vec<u8>),
    /// A variable of this capacity.
    Load(Place, u32),
    Concat(Vec<Text>),
    /// Characters from a position (from 1): text, length, position.
    Middle(Box<(Text, Expr, Expr)>, Position),
    Left(Box<(Text, Expr)>, Position),
    Right(Box<(Text, Expr)>, Position),
}

/// The call of a function.
#[derive(Clone, Debug)]
pub(crate) struct Call {
    pub(crate) pou: usize,
    pub(crate) inputs: Vec<(u32, Argument)>,
    pub(crate) outputs: Vec<Output>,
}

/// What an input gets.
#[derive(Clone, Debug)]
pub(crate) enum Argument {
    Scalar(Expr),
    /// So many cells.
    Copy(Place, u32),
    /// A string for this capacity.
    Text(Text, u32),
    /// `VAR_IN_OUT`: the address.
    Reference(Place),
}

/// `name => place`: cells of the called one go to a place.
#[derive(Clone, Debug)]
pub(crate) struct Output {
    pub(crate) from: u32,
    pub(crate) to: Place,
    pub(crate) size: u32,
}

/// A statement and its place in the text.
#[derive(Clone, Debug)]
pub(crate) struct Step {
    pub(crate) at: Position,
    pub(crate) action: Action,
}

#[derive(Clone, Debug)]
pub(crate) enum Action {
    Assign(Place, Expr),
    Copy { to: Place, from: Place, size: u32 },
    SetText { to: Place, capacity: u32, text: Text },
    If { branches: Vec<(Expr, Vec<Step>)>, otherwise: Vec<Step> },
    Case(Box<Case>),
    For(Box<For>),
    While(Expr, Vec<Step>),
    Repeat(Vec<Step>, Expr),
    Exit,
    Continue,
    Return,
    CallBlock(Box<CallBlock>),
    Discard(Expr),
}

#[derive(Clone, Debug)]
pub(crate) struct Case {
    pub(crate) selector: Expr,
    /// Ascending, without overlap: from, to, branch.
    pub(crate) labels: Vec<(i64, i64, u32)>,
    pub(crate) branches: Vec<Vec<Step>>,
    pub(crate) otherwise: Vec<Step>,
}

#[derive(Clone, Debug)]
pub(crate) struct For {
    pub(crate) control: Place,
    pub(crate) kind: Kind,
    pub(crate) start: Expr,
    pub(crate) end: Expr,
    pub(crate) step: Expr,
    pub(crate) body: Vec<Step>,
}

/// The call of a function block.
#[derive(Clone, Debug)]
pub(crate) struct CallBlock {
    pub(crate) instance: Place,
    pub(crate) pou: usize,
    pub(crate) inputs: Vec<(u32, Argument)>,
    pub(crate) outputs: Vec<Output>,
}
