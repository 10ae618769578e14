//! What is refused, and that it is refused for this reason: each rule with a text that keeps it.

use st_evaluator::Dialect::{self, Codesys, Edition2, Siemens, TwinCat};
use st_evaluator::Unit;

/// Whether a text compiles (an empty message), or what its first error says.
#[track_caller]
fn check(dialect: Dialect, text: &str, message: &str) {
    let errors = Unit::parse(text, dialect).err().unwrap_or_default();
    let shown: Vec<String> = errors.iter().map(ToString::to_string).collect();
    match errors.first() {
        None => assert_eq!(message, "", "compiles\n{text}"),
        Some(_) if message.is_empty() => panic!("{}\n{text}", shown.join("\n")),
        Some(_) => assert!(shown.iter().any(|e| e.contains(message)), "{}\n{text}", shown.join("\n")),
    }
}

/// A function block of declarations and statements.
fn block(variables: &str, statements: &str) -> String {
    let variables = if variables.is_empty() { String::new() } else { format!("VAR {variables} END_VAR") };
    format!("FUNCTION_BLOCK Block_Under_Test {variables} {statements} END_FUNCTION_BLOCK")
}

#[track_caller]
fn body(dialect: Dialect, variables: &str, statements: &str, message: &str) {
    check(dialect, &block(variables, statements), message);
}

#[test]
fn comments() {
    body(Edition2, "x : INT;", "x := 1; (* one *)", "");
    body(Edition2, "x : INT;", "x := 1; // one\n", "`//` comments");
    body(Codesys, "x : INT;", "x := 1; // one\n", "");
    body(Edition2, "x : INT;", "x := 1; (* a (* b *)", "comment within a comment");
    body(Edition2, "x : INT;", "x := 1; (* a", "the comment has no end");
}

#[test]
fn semicolons() {
    let loops = "IF b THEN b := FALSE; END_IF; WHILE b DO EXIT; END_WHILE; REPEAT b := TRUE; UNTIL b END_REPEAT; \
                 FOR i := 0 TO 1 DO b := TRUE; END_FOR; CASE i OF 1: b := FALSE; END_CASE;";
    for dialect in [Edition2, Codesys, TwinCat, Siemens] {
        body(dialect, "b : BOOL; i : INT;", loops, "");
        body(dialect, "b : BOOL;", "b := TRUE", "is missing");
    }
    for end in ["END_IF", "END_WHILE", "END_REPEAT", "END_FOR", "END_CASE"] {
        let without = loops.replace(&format!("{end};"), end);
        body(Edition2, "b : BOOL; i : INT;", &without, "`;` is missing behind the statement");
        body(Siemens, "b : BOOL; i : INT;", &without, "`;` is missing behind the statement");
        body(Codesys, "b : BOOL; i : INT;", &without, "");
    }
}

#[test]
fn statements_are_needed() {
    check(Edition2, "TYPE A : INT; END_TYPE;", "a semicolon between declarations");
    check(Codesys, "TYPE A : INT; END_TYPE;", "");
    body(Edition2, "b : BOOL;", "", "there are no statements");
    body(Edition2, "b : BOOL;", ";", "");
    body(Edition2, "b : BOOL;", "IF b THEN END_IF;", "there are no statements");
    body(Edition2, "b : BOOL;", "IF b THEN ; END_IF;", "");
    body(Codesys, "b : BOOL;", "IF b THEN END_IF;", "");
    check(Edition2, "FUNCTION_BLOCK B VAR END_VAR ; END_FUNCTION_BLOCK", "a block of variables without any");
}

#[test]
fn names_are_declared() {
    body(Edition2, "x : INT;", "y := 1;", "`y` is not declared");
    body(Edition2, "x : INT;", "x := y;", "`y` is not declared");
    body(Edition2, "x : INT;", "X := x;", "");
    body(Edition2, "x : Missing;", ";", "there is no type `Missing`");
    body(Edition2, "x : INT;", "x := missing(x);", "there is no function `missing`");
    body(Edition2, "x : R_TRIG; b : BOOL;", "x(CLOCK := b);", "there is no input `CLOCK`");
    body(Edition2, "x : R_TRIG; b : BOOL;", "b := x.P;", "has no `P`");
}

#[test]
fn names_are_declared_once() {
    body(Edition2, "x : INT; X : BOOL;", ";", "`X` is declared twice");
    check(Edition2, "TYPE A : INT; a : BOOL; END_TYPE", "`A` is declared twice");
    check(
        Edition2,
        "FUNCTION f : INT VAR_INPUT F : INT; END_VAR f := 1; END_FUNCTION",
        "`F` is declared twice",
    );
    check(
        Edition2,
        "TYPE A : INT; END_TYPE FUNCTION_BLOCK B VAR a : INT; END_VAR ; END_FUNCTION_BLOCK",
        "at the top",
    );
    check(Codesys, "TYPE A : INT; END_TYPE FUNCTION_BLOCK B VAR a : INT; END_VAR ; END_FUNCTION_BLOCK", "");
    check(Edition2, "TYPE S : STRUCT a : INT; A : INT; END_STRUCT; END_TYPE", "`A` is declared twice");
}

#[test]
fn names_are_declared_before_they_are_used() {
    let text = "FUNCTION_BLOCK B VAR a : A; END_VAR a.x := 1; END_FUNCTION_BLOCK
                TYPE A : STRUCT x : INT; END_STRUCT; END_TYPE";
    check(Edition2, text, "`A` is declared only further down");
    check(Codesys, text, "");
    check(Edition2, "FUNCTION_BLOCK B VAR x : B; END_VAR ; END_FUNCTION_BLOCK", "`B` contains itself");
    check(Codesys, "TYPE A : B; B : A; END_TYPE", "contains itself");
}

#[test]
fn names_have_a_form() {
    body(Edition2, "a__b : INT;", ";", "two underscores");
    body(Codesys, "a__b : INT;", ";", "two underscores");
    body(Siemens, "a__b : INT;", ";", "");
    body(Edition2, "a_ : INT;", ";", "ends in an underscore");
    body(Codesys, "a_ : INT;", ";", "");
    body(Edition2, "_a : INT;", ";", "");
    body(Edition2, &format!("{} : INT;", "a".repeat(63)), ";", "");
    body(Edition2, &format!("{} : INT;", "a".repeat(64)), ";", "more than 63 characters");
}

#[test]
fn reserved_words_are_no_names() {
    for word in ["Ton", "interval", "priority", "Mux", "EN", "int_to_bool", "LD", "S", "EXPT", "SINGLE"] {
        body(Edition2, &format!("{word} : INT;"), ";", "is a reserved word");
    }
    for word in ["Tone", "intervals", "Mux1", "int_to_arm", "adr1", "pending"] {
        body(Edition2, &format!("{word} : INT;"), ";", "");
    }
    body(Codesys, "Persist : INT; ", ";", "");
    body(Codesys, "sizeof : INT; ", ";", "is a reserved word");
    body(Edition2, "sizeof : INT; ", ";", "");
    check(Edition2, "FUNCTION_BLOCK Ton ; END_FUNCTION_BLOCK", "is a reserved word");
    check(Edition2, "TYPE E : (Red, Limit); END_TYPE", "is a reserved word");
    check(
        Siemens,
        "FUNCTION_BLOCK \"Ton\" VAR \"Mux\" : INT; END_VAR BEGIN #Mux := 1; END_FUNCTION_BLOCK",
        "",
    );
}

#[test]
fn types_match() {
    for dialect in [Edition2, Codesys, Siemens] {
        body(dialect, "b : BOOL; i : INT;", "b := i;", "`INT` where `BOOL` is wanted");
        body(dialect, "b : BOOL; i : INT;", "i := b;", "`BOOL` where `INT` is wanted");
        body(dialect, "b : BOOL; i : INT;", "b := 1;", "an integer where `BOOL` is wanted");
        body(dialect, "b : BOOL; i : INT;", "i := TRUE;", "`BOOL` where `INT` is wanted");
        body(dialect, "i : INT; k : DINT;", "i := k;", "`DINT` where `INT` is wanted");
        body(dialect, "i : INT; b : BOOL;", "IF i THEN b := TRUE; END_IF;", "`INT` where `BOOL` is wanted");
        body(dialect, "i : INT; u : UINT;", "i := u;", "`UINT` where `INT` is wanted");
        body(dialect, "i : INT; b : BOOL;", "b := b AND i;", "do not go together");
        body(dialect, "i : INT; t : TIME;", "t := i;", "`INT` where `TIME` is wanted");
        body(dialect, "b : BOOL;", "b := b + b;", "`+` of `BOOL`");
        body(dialect, "i : INT; s : STRING;", "i := s;", "a single value is wanted");
    }
}

#[test]
fn integers_widen_only_in_the_dialects() {
    body(Edition2, "i : INT; k : DINT;", "k := i;", "`INT` where `DINT` is wanted");
    body(Edition2, "i : INT; k : DINT;", "k := INT_TO_DINT(i);", "");
    body(Edition2, "i : INT; k : DINT; b : BOOL;", "b := i = k;", "do not go together");
    body(Edition2, "i : INT; k : DINT;", "k := k + i;", "do not go together");
    body(Codesys, "i : INT; d : DINT; u : USINT;", "d := i; i := u; d := d + i;", "");
    body(Siemens, "i : INT; d : DINT; u : USINT;", "d := i; i := u; d := d + i;", "");
    body(Codesys, "a : BYTE; w : WORD;", "w := a;", "");
    body(Codesys, "a : BYTE; w : WORD; u : UINT; i : INT;", "u := a; u := w; w := u; i := a;", "");
    body(Codesys, "w : WORD; i : INT;", "i := w;", "`WORD` where `INT` is wanted");
    body(Siemens, "a : BYTE; u : UINT;", "u := a;", "`BYTE` where `UINT` is wanted");
    body(Codesys, "a : BYTE; w : WORD;", "a := w;", "`WORD` where `BYTE` is wanted");
}

#[test]
fn literals_take_the_type_that_is_wanted() {
    body(Edition2, "a : USINT; b : LINT; w : WORD;", "a := 255; b := -5; w := 16#FFFF; a := USINT#3;", "");
    body(Edition2, "a : USINT;", "a := 256;", "256 is not within `USINT`");
    body(Edition2, "a : USINT;", "a := -1;", "-1 is not within `USINT`");
    body(Edition2, "a : SINT;", "a := -128; a := 128;", "128 is not within `SINT`");
    body(Edition2, "a : WORD;", "a := 16#1_0000;", "is not within `WORD`");
    body(Edition2, "a : INT; b : BOOL;", "b := a = 40000;", "40000 is not within `INT`");
    body(Edition2, "a : INT;", "a := UINT#3;", "`UINT` where `INT` is wanted");
    body(Edition2, "a : INT;", "a := USINT#300;", "300 is not within `USINT`");
    body(Edition2, "a : INT := 40000;", ";", "40000 is not within `INT`");
    body(Edition2, "a : ARRAY [0..1] OF USINT := [1, 300];", ";", "300 is not within `USINT`");
    body(Edition2, "a : INT;", "a := 1 / 0;", "cannot be computed");
    body(Edition2, "a : INT;", "a := INT#30000 + INT#30000;", "not within `INT`");
}

#[test]
fn bit_strings_are_no_numbers() {
    body(Edition2, "w : WORD; i : INT;", "w := w AND 16#FF; w := SHL(w, 3); w := NOT w;", "");
    body(Edition2, "w : WORD; i : INT;", "i := i AND 3;", "`AND` of `INT`");
    body(Siemens, "w : WORD; i : INT;", "i := i AND 3;", "`AND` of `INT`");
    body(Codesys, "w : WORD; i : INT;", "i := i AND 3; w := w + 1;", "");
    body(Edition2, "w : WORD; i : INT;", "w := w + 1;", "`+` of `WORD`");
    body(Edition2, "i : INT;", "i := SHL(i, 1);", "has no bits to shift");
    body(Edition2, "i : INT;", "i := NOT i;", "`NOT` of `INT`");
    body(Edition2, "w : WORD; u : UINT;", "u := w;", "`WORD` where `UINT` is wanted");
    body(Edition2, "w : WORD; u : UINT;", "u := WORD_TO_UINT(w);", "");
}

#[test]
fn arrays_are_assigned_by_name_of_type() {
    let types = "TYPE T : ARRAY [0..3] OF INT; U : ARRAY [0..3] OF INT; V : T; END_TYPE ";
    let with = |variables: &str, statements: &str| types.to_owned() + &block(variables, statements);
    check(Edition2, &with("a, b : T;", "a := b;"), "");
    check(Edition2, &with("a : T; b : V;", "a := b;"), "");
    check(Edition2, &with("a : T; b : U;", "a := b;"), "not the same type by name");
    check(Codesys, &with("a : T; b : U;", "a := b;"), "");
    body(
        Edition2,
        "a : ARRAY [0..3] OF INT; b : ARRAY [0..3] OF INT;",
        "a := b;",
        "not the same type by name",
    );
    body(Edition2, "a, b : ARRAY [0..3] OF INT;", "a := b;", "not the same type by name");
    body(Codesys, "a : ARRAY [0..3] OF INT; b : ARRAY [0..3] OF INT;", "a := b;", "");
    body(
        Codesys,
        "a : ARRAY [0..3] OF INT; b : ARRAY [0..2] OF INT;",
        "a := b;",
        "where `ARRAY [0..3] OF INT`",
    );
    body(Edition2, "a : R_TRIG; b : R_TRIG;", "a := b;", "instances of function blocks are not assigned");
}

#[test]
fn indices() {
    body(Edition2, "a : ARRAY [1..3] OF INT; i : INT;", "a[3] := a[1]; a[i + 1] := 0;", "");
    body(Edition2, "a : ARRAY [1..3] OF INT;", "a[4] := 0;", "index 4 is outside of [1..3]");
    body(Edition2, "a : ARRAY [1..3] OF INT;", "a[0] := 0;", "index 0 is outside of [1..3]");
    body(Edition2, "a : ARRAY [1..3] OF INT; b : BOOL;", "a[b] := 0;", "an integer is wanted");
    body(Edition2, "a : ARRAY [1..3] OF INT;", "a[1, 2] := 0;", "the array has 1 indices");
    body(Edition2, "a : INT;", "a[1] := 0;", "`INT` is no array");
    body(Edition2, "a : ARRAY [0..1] OF ARRAY [0..1] OF INT;", "a[1][1] := 0;", "");
    body(Edition2, "a : ARRAY [3..1] OF INT;", ";", "the lower limit is above the upper one");
    body(Edition2, "a : ARRAY [0..1] OF INT := [1, 2, 3];", ";", "more initial values than the 2 elements");
    body(Edition2, "a : ARRAY [0..3] OF INT := [2(1, 2)];", ";", "");
    body(Edition2, "a : ARRAY [0..3] OF INT := [5(1)];", ";", "more initial values than the 4 elements");
}

#[test]
fn limits_and_initial_values_are_literals() {
    let variables = "VAR CONSTANT k : INT := 3; END_VAR VAR a : ARRAY [0..k - 1] OF INT; END_VAR";
    check(Edition2, &format!("FUNCTION_BLOCK B {variables} a[2] := k; END_FUNCTION_BLOCK"), "only a literal");
    check(Codesys, &format!("FUNCTION_BLOCK B {variables} a[2] := k; END_FUNCTION_BLOCK"), "");
    check(
        Codesys,
        &format!("FUNCTION_BLOCK B {variables} a[3] := k; END_FUNCTION_BLOCK"),
        "index 3 is outside",
    );
    body(Edition2, "a : INT := 1 + 2;", ";", "only a literal can stand here");
    body(Codesys, "a : INT := 1 + 2;", ";", "");
    body(Codesys, "a : INT; b : INT := a;", ";", "`A` is no constant");
}

#[test]
fn cases() {
    body(Edition2, "i : INT;", "CASE i OF 1, 3..5: i := 0; -1: i := 2; ELSE i := 1; END_CASE;", "");
    body(Edition2, "i : INT;", "CASE i OF 1: i := 0; 1: i := 1; END_CASE;", "1 is a label twice");
    body(Edition2, "i : INT;", "CASE i OF 1..4: i := 0; 3: i := 1; END_CASE;", "3 is a label twice");
    body(Edition2, "i : INT;", "CASE i OF 4..1: i := 0; END_CASE;", "the range is empty");
    body(Edition2, "i : USINT;", "CASE i OF 300: i := 0; END_CASE;", "300 is not within `USINT`");
    body(Edition2, "i : INT;", "CASE i OF UINT#3: i := 0; END_CASE;", "`UINT` where `INT` is wanted");
    body(Edition2, "i : INT; j : INT;", "CASE i OF j: i := 0; END_CASE;", "only a literal can stand here");
    body(Edition2, "b : BOOL;", "CASE b OF TRUE: b := FALSE; END_CASE;", "one of integers and enumerations");
    let types = "TYPE E : (Red, Green); F : (Blue, Grey); END_TYPE ";
    let with = |statements: &str| types.to_owned() + &block("c : E;", statements);
    check(Edition2, &with("CASE c OF Red: c := Green; E#Green: c := Red; END_CASE;"), "");
    check(Edition2, &with("CASE c OF Blue: c := Green; END_CASE;"), "`F` where `E` is wanted");
    check(Edition2, &with("CASE c OF 1: c := Green; END_CASE;"), "an integer where `E` is wanted");
    check(Edition2, &with("c := E.Green;"), "is written `Type#value`");
    check(Codesys, &with("c := E.Green;"), "");
    check(Edition2, &with("c := E#Blue;"), "`E` has no value `BLUE`");
}

#[test]
fn loops() {
    body(Edition2, "i : INT; b : BOOL;", "FOR i := 0 TO 3 DO b := i = 2; END_FOR;", "");
    body(
        Edition2,
        "i : INT;",
        "FOR i := 0 TO 3 DO i := 2; END_FOR;",
        "the control variable of a loop is not written",
    );
    body(Codesys, "i : INT;", "FOR i := 0 TO 3 DO i := 2; END_FOR;", "");
    body(Edition2, "i : INT; k : DINT;", "FOR i := 0 TO k DO ; END_FOR;", "`DINT` where `INT` is wanted");
    body(Edition2, "b : BOOL;", "FOR b := FALSE TO TRUE DO ; END_FOR;", "the control variable is an integer");
    body(Edition2, "i : USINT;", "FOR i := 0 TO 300 DO ; END_FOR;", "300 is not within `USINT`");
    body(Edition2, "i : INT;", "FOR i := 0 TO 3 BY 0 DO ; END_FOR;", "the step is 0");
    body(Edition2, "i : INT;", "EXIT;", "`EXIT` outside of a loop");
    body(Edition2, "i : INT;", "WHILE i < 3 DO EXIT; END_WHILE;", "");
    body(
        Edition2,
        "i : INT;",
        "WHILE i < 3 DO CONTINUE; END_WHILE;",
        "`CONTINUE` is not in the second edition",
    );
    body(Codesys, "i : INT;", "WHILE i < 3 DO CONTINUE; END_WHILE;", "");
    body(Edition2, "i : INT;", "WHILE i DO ; END_WHILE;", "`INT` where `BOOL` is wanted");
}

#[test]
fn constants_and_inputs_are_not_written() {
    let with = |section: &str, statements: &str| {
        format!("FUNCTION_BLOCK B {section} x : INT := 1; END_VAR {statements} END_FUNCTION_BLOCK")
    };
    check(Edition2, &with("VAR CONSTANT", "x := 2;"), "a constant is not written");
    check(Codesys, &with("VAR CONSTANT", "x := 2;"), "a constant is not written");
    check(Edition2, &with("VAR_INPUT", "x := 2;"), "an input is not written");
    check(Codesys, &with("VAR_INPUT", "x := 2;"), "");
    check(Edition2, &with("VAR_OUTPUT", "x := x + 2;"), "");
    check(Edition2, &with("VAR_TEMP", "x := 2;"), "");
    check(Edition2, &with("VAR_INPUT", "FOR x := 1 TO 2 DO ; END_FOR;"), "an input is not written");
    check(Edition2, &with("VAR RETAIN", "x := 2;"), "");
    check(Edition2, &with("VAR_TEMP RETAIN", "x := 2;"), "cannot be retained");
    check(Edition2, &with("VAR_INPUT CONSTANT", ";"), "cannot be constant");
}

#[test]
fn variables_of_instances() {
    let block = "FUNCTION_BLOCK F VAR_INPUT i : INT; END_VAR VAR_OUTPUT o : INT; END_VAR VAR v : INT; END_VAR
                 VAR_IN_OUT io : INT; END_VAR o := i; v := io; END_FUNCTION_BLOCK ";
    let with = |body: &str| {
        format!("{block} FUNCTION_BLOCK B VAR g : F; x : INT; END_VAR {body} END_FUNCTION_BLOCK")
    };
    check(Edition2, &with("g(i := 1, io := x, o => x);"), "");
    check(Edition2, &with("g(1, x); x := g.o;"), "");
    check(Edition2, &with("g(i := 1);"), "`io` must be given");
    check(Edition2, &with("g(i := 1, io := 3);"), "a variable is wanted");
    check(Edition2, &with("g(i := 1, i := 2, io := x);"), "`i` is given twice");
    check(Edition2, &with("g(i := 1, x);"), "with and without names");
    check(Edition2, &with("g(1, x, 3);"), "3 arguments, 2 are wanted");
    check(Edition2, &with("g(v := 1, io := x);"), "there is no input `V`");
    check(Edition2, &with("g(i := TRUE, io := x);"), "`BOOL` where `INT` is wanted");
    check(Edition2, &with("g.o := 1;"), "an output is written by its function block only");
    check(Codesys, &with("g.o := 1;"), "an output is written by its function block only");
    check(Edition2, &with("x := g.v;"), "`v` is not visible from outside");
    check(Edition2, &with("g.i := 1;"), "an input cannot be used from outside");
    check(Codesys, &with("g.i := 1; x := g.i;"), "");
    check(Edition2, &with("x := g(i := 1, io := x);"), "there is no function `g`");
    check(Edition2, &with("G(i := 1, io := x);"), "");
    check(
        Edition2,
        "FUNCTION_BLOCK B TON(IN := TRUE, PT := T#1s); END_FUNCTION_BLOCK",
        "an instance is called",
    );
}

#[test]
fn functions() {
    let with =
        |inside: &str| format!("FUNCTION f : INT VAR_INPUT a, c : INT; END_VAR {inside} END_FUNCTION ");
    let used = |inside: &str, body: &str| {
        with(inside) + "FUNCTION_BLOCK B VAR x : INT; t : BOOL; END_VAR " + body + " END_FUNCTION_BLOCK"
    };
    check(Edition2, &used("f := a + c;", "x := f(1, x); x := f(a := 1, c := 2); x := f(a := 1);"), "");
    check(Edition2, &used("f := a + c;", "x := f(1);"), "1 arguments, 2 are wanted");
    check(Edition2, &used("f := a + c;", "x := f(1, t);"), "`BOOL` where `INT` is wanted");
    check(Edition2, &used("f := a + c;", "t := f(1, 2);"), "`INT` where `BOOL` is wanted");
    check(Edition2, &used("f := a + c;", "f(1, 2);"), "a function is called in an expression");
    check(Codesys, &used("f := a + c;", "f(1, 2);"), "");
    check(Edition2, &with("a := 1; f := a;"), "an input is not written");
    check(Edition2, &with("RETURN;"), "the function does not assign its result");
    check(Edition2, &with("f := f(1, 2);"), "the function calls itself");
    check(Edition2, &with("VAR t : TON; END_VAR f := 1;"), "a function has no instances of function blocks");
    check(Edition2, &with("VAR_EXTERNAL g : INT; END_VAR f := 1;"), "a function has no `VAR_EXTERNAL`");
    check(Edition2, &with("VAR RETAIN g : INT; END_VAR f := 1;"), "a function retains nothing");
    let circle = "FUNCTION f : INT VAR_INPUT a : INT; END_VAR f := g(a); END_FUNCTION
                  FUNCTION g : INT VAR_INPUT a : INT; END_VAR g := f(a); END_FUNCTION";
    check(Codesys, circle, "the function calls itself");
}

#[test]
fn pointers() {
    let variables =
        "a : ARRAY [0..3] OF UINT; p : POINTER TO ARRAY [0..3] OF UINT; q : POINTER TO UINT; x : UINT;";
    body(Edition2, variables, ";", "this dialect has no pointers");
    body(Siemens, variables, ";", "this dialect has no pointers");
    for dialect in [Codesys, TwinCat] {
        body(
            dialect,
            variables,
            "p := ADR(a); x := p^[1]; q := ADR(a); x := q[2]; q^ := 3; q := ADR(x);",
            "",
        );
        body(dialect, variables, "x := p;", "where `UINT` is wanted");
        body(dialect, variables, "x := x^;", "`UINT` is no pointer");
        body(dialect, variables, "p := a;", "a single value is wanted");
        body(
            dialect,
            "a : ARRAY [0..3] OF INT; q : POINTER TO UINT;",
            "q := ADR(a);",
            "the address of `INT`",
        );
        body(dialect, "a : ARRAY [0..3] OF INT; x : DINT;", "x := SIZEOF(a) - 1;", "");
    }
}

#[test]
fn short_circuits() {
    body(Codesys, "a, b : BOOL; i : INT;", "a := a AND_THEN b OR_ELSE a;", "");
    body(Codesys, "a, b : BOOL; i : INT;", "i := i AND_THEN i;", "only of `BOOL`");
    body(Edition2, "a, b : BOOL;", "a := a AND_THEN b;", "`AND_THEN` is no operator");
}

#[test]
fn globals() {
    let program = |variables: &str, body: &str| {
        format!(
            "PROGRAM Main {variables} {body} END_PROGRAM
             CONFIGURATION C VAR_GLOBAL g : INT; END_VAR RESOURCE R1x ON PLC TASK K(INTERVAL := T#1ms, PRIORITY := 1);
             PROGRAM M WITH K : Main; END_RESOURCE END_CONFIGURATION"
        )
    };
    check(Edition2, &program("VAR_EXTERNAL g : INT; END_VAR", "g := 1;"), "");
    check(Edition2, &program("VAR_EXTERNAL g : BOOL; END_VAR", "g := TRUE;"), "has another type");
    check(Edition2, &program("VAR_EXTERNAL h : INT; END_VAR", "h := 1;"), "there is no global variable `h`");
    check(Edition2, &program("", "g := 1;"), "`g` is not declared");
    check(Codesys, &program("", "g := 1;"), "");
    check(
        Codesys,
        "VAR_GLOBAL CONSTANT n : INT := 3; END_VAR FUNCTION_BLOCK B n := 1; END_FUNCTION_BLOCK",
        "constant",
    );
    check(Edition2, "VAR_GLOBAL n : INT; END_VAR", "stands in a configuration");
}

#[test]
fn configurations() {
    let with = |task: &str, program: &str| {
        format!(
            "PROGRAM Main ; END_PROGRAM FUNCTION_BLOCK B ; END_FUNCTION_BLOCK
             CONFIGURATION Config0 RESOURCE Res0 ON PLC {task} {program} END_RESOURCE END_CONFIGURATION"
        )
    };
    let task = "TASK K(INTERVAL := T#10ms, PRIORITY := 1);";
    check(Edition2, &with(task, "PROGRAM M WITH K : Main;"), "");
    check(Edition2, &with(task, "PROGRAM M WITH K : Main(x := y);"), "connections of a program");
    check(Edition2, &with(task, "PROGRAM M WITH L : Main;"), "there is no task `L`");
    check(Edition2, &with(task, "PROGRAM M WITH K : B;"), "there is no program `B`");
    check(Edition2, &with(task, "PROGRAM M WITH K : Q;"), "there is no program `Q`");
    check(Edition2, &with("TASK K(INTERVAL := 10, PRIORITY := 1);", ""), "a duration is wanted");
    check(Edition2, &with("TASK K(INTERVAL := T#10ms);", ""), "a task has a `PRIORITY`");
    check(Edition2, &with(task, "PROGRAM B WITH K : Main;"), "declared at the top, too");
}

#[test]
fn strings() {
    body(Edition2, "t1 : STRING[5] := 'abc'; i : INT;", "t1 := 'de'; i := LEN(t1); t1 := MID(t1, 1, 2);", "");
    body(Edition2, "s : STRING(5);", ";", "stands in `[ ]`");
    body(Codesys, "s : STRING(5);", ";", "");
    body(Edition2, "s : STRING[2] := 'abc';", ";", "more than 2 characters");
    body(Edition2, "s : STRING[5]; i : INT;", "s := i;", "a string is wanted");
    body(Edition2, "s : STRING[5]; b : BYTE;", "b := s[0];", "no characters of strings");
    body(Codesys, "s : STRING[5]; b : BYTE;", "b := s[0];", "");
    body(Siemens, "s : STRING[5]; c : CHAR;", "c := s[1];", "");
    body(Siemens, "s : STRING[5]; c : CHAR;", "c := s[0];", "index 0 is outside of [1..5]");
    body(Edition2, "t1 : STRING[5]; b : BOOL;", "b := t1 = 'x';", "");
}

#[test]
fn subranges() {
    check(
        Edition2,
        "TYPE Few : INT (0..5) := 3; END_TYPE FUNCTION_BLOCK B VAR x : Few; END_VAR x := 5; END_FUNCTION_BLOCK",
        "",
    );
    body(Edition2, "x : INT (0..5);", "x := 6;", "6 is not within `INT (0..5)`");
    body(Edition2, "x : INT (0..5); b : BOOL;", "b := x = 6;", "");
    body(Edition2, "x : USINT (0..300);", ";", "is not within `USINT`");
    body(Edition2, "x : BOOL (0..1);", ";", "only integers have subranges");
}

#[test]
fn siemens() {
    let constant =
        |ty: &str| format!("FUNCTION_BLOCK \"B\" VAR CONSTANT a : {ty}; END_VAR BEGIN ; END_FUNCTION_BLOCK");
    check(Siemens, &constant("Array[0..1] of Int := [1, 2]"), "constants of SCL have elementary types");
    check(Siemens, &constant("Int := 3"), "");
}

#[test]
fn what_is_not_supported_is_said() {
    body(Edition2, "x : REAL;", ";", "`REAL` is not supported");
    body(Edition2, "x : INT;", "x := 2.5;", "`real_literal` is not supported");
    body(Edition2, "x : INT;", "x := 2 ** 2;", "`**` is not supported");
    body(Codesys, "x : REF_TO INT;", ";", "`reference_type` is not supported");
    body(Codesys, "x : TIME;", "x := LTIME#1s;", "the duration cannot be read");
    check(Codesys, "ABSTRACT FUNCTION_BLOCK B ; END_FUNCTION_BLOCK", "`ABSTRACT` is not supported");
    check(Codesys, "INTERFACE I END_INTERFACE", "`interface_declaration` is not supported");
}

#[test]
fn places_are_exact() {
    let text =
        "FUNCTION_BLOCK B\nVAR\n  x : INT;\nEND_VAR\n  x := y;\n  (* ok *) z := 1;\nEND_FUNCTION_BLOCK\n";
    let errors = Unit::parse(text, Edition2).expect_err("two names are not declared");
    let places: Vec<(u32, u32)> = errors.iter().map(|e| (e.line, e.column)).collect();
    assert_eq!(places, [(5, 8), (6, 12)]);
    let errors =
        Unit::parse("FUNCTION_BLOCK B\n  x := ;\nEND_FUNCTION_BLOCK", Edition2).expect_err("no value");
    assert_eq!(errors[0].line, 2);
    let errors = Unit::parse("FUNCTION_BLOCK B\n  x := 1;\n", Edition2).expect_err("no end");
    assert!(errors.iter().all(|error| error.line <= 3), "{errors:?}");
}

#[track_caller]
fn unreadable(dialect: Dialect, text: &str) {
    let errors = Unit::parse(text, dialect).err().unwrap_or_default();
    let syntax = |message: &str| message.contains("cannot be read") || message.contains("is missing");
    assert!(errors.iter().any(|error| syntax(&error.message)), "{errors:?}\n{text}");
}

/// What the crate's documentation says that the grammar cannot read. If one of these passes, it can be supported.
#[test]
fn limits_of_the_grammar() {
    let point = "TYPE A : STRUCT x : INT; END_STRUCT; END_TYPE ";
    unreadable(Edition2, "TYPE A : ARRAY [0..1] OF INT := [1, 2]; END_TYPE");
    unreadable(Edition2, "TYPE A : STRUCT x : ARRAY [0..1] OF INT := [1, 2]; END_STRUCT; END_TYPE");
    unreadable(Edition2, &(point.to_owned() + &block("a : ARRAY [0..1] OF A := [(x := 1), (x := 2)];", ";")));
    unreadable(Edition2, &block("a : ARRAY [0..1] OF ARRAY [0..1] OF INT := [[1, 2], [3, 4]];", ";"));
    unreadable(Codesys, "FUNCTION f VAR x : INT; END_VAR x := 1; END_FUNCTION");
    unreadable(Codesys, "TYPE E : (Red, Green) INT; END_TYPE");
    unreadable(Edition2, &block("f : R_TRIG; b : BOOL;", "f(CLK := b, NOT Q => b);"));
    unreadable(Edition2, "FUNCTION_BLOCK B VAR_INPUT x : BOOL R_EDGE; END_VAR ; END_FUNCTION_BLOCK");
    unreadable(Edition2, &block("adr : INT;", "adr := 1;"));
    for word in ["this", "super"] {
        body(Edition2, &format!("{word} : INT;"), &format!("{word} := 1;"), "_expression` is not supported");
    }
}
