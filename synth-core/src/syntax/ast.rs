//! The syntax tree of SML, as written: names are not resolved, older spellings are already normalised.

use super::Span;

/// A name with its place.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Name {
    /// The identifier.
    pub text: String,
    /// Where it stands.
    pub span: Span,
}

/// `import "…"`.
#[derive(Clone, PartialEq, Debug)]
pub struct Import {
    /// The path as written, relative to the importing file.
    pub path: String,
    /// The string literal.
    pub span: Span,
}

/// One file: `import* specification ID { section* }`.
#[derive(Clone, PartialEq, Debug)]
pub struct File {
    /// In textual order.
    pub imports: Vec<Import>,
    /// The specification's name.
    pub name: Name,
    /// In textual order.
    pub sections: Vec<Section>,
    /// Whether everything that declares a name was read: mistakes, if any, cost only scenarios, effects and the like.
    pub declares_all: bool,
}

/// A section of a specification.
#[derive(Clone, PartialEq, Debug)]
pub enum Section {
    /// `domain … { enum* class* }`.
    Domain(Vec<DomainItem>),
    /// `object o: C { a: v }`.
    Object(Object),
    /// `effects { … }`.
    Effects(Vec<Effect>),
    /// `controllable { C … }`.
    Controllable(Controllable),
    /// `non-spontaneous events { C.op … }`.
    NonSpontaneous(Vec<EventRef>),
    /// `parameter ranges { … }`.
    ParameterRanges(Vec<ParameterRanges>),
    /// `channels { … }`.
    Channels(Vec<Channel>),
    /// `collaboration X { … }`.
    Collaboration(Collaboration),
}

/// An enum or a class.
#[derive(Clone, PartialEq, Debug)]
pub enum DomainItem {
    /// `enum E { a, b }`.
    Enum(Enum),
    /// `class C : B { … }`.
    Class(Class),
}

/// `enum E { a, b }`.
#[derive(Clone, PartialEq, Debug)]
pub struct Enum {
    /// Its name.
    pub name: Name,
    /// At least one.
    pub literals: Vec<Name>,
}

/// `abstract? class C : Base { attribute* operation* }`.
#[derive(Clone, PartialEq, Debug)]
pub struct Class {
    /// Has no objects of its own.
    pub is_abstract: bool,
    /// Its name.
    pub name: Name,
    /// The class it inherits from.
    pub base: Option<Name>,
    /// In textual order.
    pub attributes: Vec<Attribute>,
    /// In textual order.
    pub operations: Vec<Operation>,
}

/// `name: type = literal`.
#[derive(Clone, PartialEq, Debug)]
pub struct Attribute {
    /// Its name.
    pub name: Name,
    /// Its type.
    pub ty: Type,
    /// The declared initial value; only literals pass the parser.
    pub initial: Option<Expr>,
}

/// `name(p: type, …)`.
#[derive(Clone, PartialEq, Debug)]
pub struct Operation {
    /// Its name.
    pub name: Name,
    /// Name and type of each parameter.
    pub parameters: Vec<(Name, Type)>,
}

/// A type as written.
#[derive(Clone, PartialEq, Debug)]
pub struct Type {
    /// What it is.
    pub kind: TypeKind,
    /// Where it stands.
    pub span: Span,
}

/// The kinds of types.
#[derive(Clone, PartialEq, Debug)]
pub enum TypeKind {
    /// `bool`.
    Bool,
    /// `lo..=hi`, both ends included.
    Int(i64, i64),
    /// An enum or a class.
    Named(String),
}

/// `object o: C { a: v, … }`.
#[derive(Clone, PartialEq, Debug)]
pub struct Object {
    /// Its name.
    pub name: Name,
    /// Its class.
    pub class: Name,
    /// Initial values; only literals pass the parser.
    pub values: Vec<(Name, Expr)>,
}

/// `Sender -> Receiver.operation(p, …) { path = expr … }`.
#[derive(Clone, PartialEq, Debug)]
pub struct Effect {
    /// An object or a class.
    pub sender: Name,
    /// An object or a class.
    pub receiver: Name,
    /// The operation.
    pub operation: Name,
    /// Names that stand for the arguments inside this effect.
    pub parameters: Vec<Name>,
    /// In textual order.
    pub assignments: Vec<(Path, Expr)>,
}

/// `controllable { C … }`.
#[derive(Clone, PartialEq, Debug)]
pub struct Controllable {
    /// The keyword.
    pub keyword: Span,
    /// Class names.
    pub classes: Vec<Name>,
}

/// `Class.operation`.
#[derive(Clone, PartialEq, Debug)]
pub struct EventRef {
    /// The receiver's class.
    pub class: Name,
    /// Its operation.
    pub operation: Name,
}

/// `C.op(p = [span, …], …)`.
#[derive(Clone, PartialEq, Debug)]
pub struct ParameterRanges {
    /// Which operation.
    pub event: EventRef,
    /// Per parameter, the spans of its values.
    pub parameters: Vec<(Name, Vec<RangeSpan>)>,
}

/// One literal, or `lo..hi` with both ends included.
#[derive(Clone, PartialEq, Debug)]
pub struct RangeSpan {
    /// First value (a literal).
    pub low: Expr,
    /// Last value; `None` for a single literal.
    pub high: Option<Expr>,
}

/// `C.op over Sender.reference`.
#[derive(Clone, PartialEq, Debug)]
pub struct Channel {
    /// Which operation.
    pub event: EventRef,
    /// Class of the sender.
    pub class: Name,
    /// Its attribute that must hold the receiver.
    pub reference: Name,
}

/// `collaboration X { role* scenario* }`.
#[derive(Clone, PartialEq, Debug)]
pub struct Collaboration {
    /// Its name.
    pub name: Name,
    /// In textual order.
    pub roles: Vec<Role>,
    /// In textual order.
    pub scenarios: Vec<Scenario>,
}

/// `static|dynamic role C r`.
#[derive(Clone, PartialEq, Debug)]
pub struct Role {
    /// Bound per scenario copy; a static role is the object of its name.
    pub dynamic: bool,
    /// The class of the objects that can play it.
    pub class: Name,
    /// Its name.
    pub name: Name,
}

/// What a scenario says, and of whom.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum ScenarioKind {
    /// What the environment does.
    Assumption,
    /// What the controller must do.
    Guarantee,
    /// What should be possible; followed beside the game.
    Existential,
}

/// `guarantee scenario X bindings [ … ] { … } constraints [ … ]`.
#[derive(Clone, PartialEq, Debug)]
pub struct Scenario {
    /// Text of the `///` lines directly above, one entry a line, without the slashes and one leading space.
    pub requirement: Vec<String>,
    /// Assumption, guarantee or existential.
    pub kind: ScenarioKind,
    /// Its name.
    pub name: Name,
    /// `bindings [role = expr …]`.
    pub bindings: Vec<(Name, Expr)>,
    /// The whole scenario.
    pub body: Body,
}

/// `{ fragment* } constraints [ … ]`.
#[derive(Clone, PartialEq, Debug)]
pub struct Body {
    /// In textual order.
    pub fragments: Vec<Fragment>,
    /// In textual order.
    pub constraints: Vec<Constraint>,
    /// From brace to brace.
    pub span: Span,
}

/// The kinds of constraint.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ConstraintKind {
    /// The message must not happen.
    Forbidden,
    /// The message does not concern the copy.
    Ignore,
    /// The message ends the copy.
    Interrupt,
    /// The message counts as one of the scenario's own.
    Consider,
}

/// `forbidden|ignore|interrupt|consider message`.
#[derive(Clone, PartialEq, Debug)]
pub struct Constraint {
    /// Which.
    pub kind: ConstraintKind,
    /// The pattern.
    pub message: Message,
    /// Keyword and message.
    pub span: Span,
}

/// A part of a body.
#[derive(Clone, PartialEq, Debug)]
pub struct Fragment {
    /// What it is.
    pub kind: FragmentKind,
    /// The whole fragment.
    pub span: Span,
}

/// The kinds of fragment.
#[derive(Clone, PartialEq, Debug)]
pub enum FragmentKind {
    /// A nested body.
    Body(Body),
    /// `strict? monitored? eventually|urgent|… message`.
    Message(Modifier, Message),
    /// `alternative [c] { … } or [c] { … }`.
    Alternative(Vec<Case>),
    /// `parallel { … } and { … }`.
    Parallel(Vec<Body>),
    /// `while [c] { … }`.
    While(Option<Expr>, Body),
    /// `wait strict? eventually? [c]`.
    Wait {
        /// A message out of order violates instead of ending the copy.
        strict: bool,
        /// Passing is an obligation.
        eventually: bool,
        /// What is waited for.
        condition: Expr,
    },
    /// `interrupt [c]`.
    Interrupt(Expr),
    /// `violation [c]`.
    Violation(Expr),
    /// `var type name = expr`.
    Variable(Type, Name, Option<Expr>),
    /// `name = expr`.
    Assignment(Name, Expr),
}

/// A case of an `alternative`.
#[derive(Clone, PartialEq, Debug)]
pub struct Case {
    /// Offered only if it holds when the cut gets there.
    pub condition: Option<Expr>,
    /// What then happens.
    pub body: Body,
}

/// How urgently a message must happen.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Modality {
    /// At some time.
    Eventually,
    /// Before the environment's next event.
    Urgent,
    /// As `urgent`.
    Requested,
    /// Before anything else.
    Committed,
}

/// `strict? (monitored? modality)?`.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Modifier {
    /// A message out of order violates instead of ending the copy.
    pub strict: bool,
    /// An obligation, but not a cause.
    pub monitored: bool,
    /// `None`: the message is only waited for.
    pub modality: Option<Modality>,
}

/// `sender -> receiver.operation(argument, …)`.
#[derive(Clone, PartialEq, Debug)]
pub struct Message {
    /// A role or an object.
    pub sender: Name,
    /// A role or an object.
    pub receiver: Name,
    /// An operation of the receiver's class, or an implicit `setX`.
    pub operation: Name,
    /// Empty when the parentheses are left out.
    pub arguments: Vec<Argument>,
    /// From the sender to the closing parenthesis.
    pub span: Span,
}

/// An argument of a message.
#[derive(Clone, PartialEq, Debug)]
pub struct Argument {
    /// What it is.
    pub kind: ArgumentKind,
    /// Where it stands.
    pub span: Span,
}

/// The kinds of argument.
#[derive(Clone, PartialEq, Debug)]
pub enum ArgumentKind {
    /// `*`: any value.
    Any,
    /// `bind v`: any value, which the variable takes.
    Bind(Name),
    /// The value of an expression.
    Value(Expr),
}

/// `a.b.c`.
#[derive(Clone, PartialEq, Debug)]
pub struct Path {
    /// At least one.
    pub names: Vec<Name>,
    /// From the first to the last.
    pub span: Span,
}

/// An expression.
#[derive(Clone, PartialEq, Debug)]
pub struct Expr {
    /// What it is.
    pub kind: ExprKind,
    /// The whole expression, without enclosing parentheses.
    pub span: Span,
}

/// The kinds of expression.
#[derive(Clone, PartialEq, Debug)]
pub enum ExprKind {
    /// `true`, `false`.
    Bool(bool),
    /// A decimal integer; a literal with a sign is folded.
    Int(i64),
    /// `null`.
    Null,
    /// `Enum:literal`.
    Literal(Name, Name),
    /// A variable, role, object, enum literal or parameter, and attributes behind it.
    Path(Path),
    /// `!a`, `-a`.
    Unary(UnaryOp, Box<Expr>),
    /// `a op b`.
    Binary(BinaryOp, Box<Expr>, Box<Expr>),
}

/// Unary operators.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum UnaryOp {
    /// `!`.
    Not,
    /// `-`.
    Neg,
}

/// Binary operators.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum BinaryOp {
    /// `=>`, right-associative.
    Implies,
    /// `||`.
    Or,
    /// `&&`.
    And,
    /// `==`.
    Eq,
    /// `!=`.
    Ne,
    /// `<`.
    Lt,
    /// `<=`.
    Le,
    /// `>`.
    Gt,
    /// `>=`.
    Ge,
    /// `+`.
    Add,
    /// `-`.
    Sub,
    /// `*`.
    Mul,
}
