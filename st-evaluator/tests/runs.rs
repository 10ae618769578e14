//! What texts do.

use std::time::Duration;

use st_evaluator::Dialect::{self, Codesys, Edition2, Siemens};
use st_evaluator::{Instance, Unit, Value};

#[track_caller]
fn unit(dialect: Dialect, text: &str) -> Unit {
    Unit::parse(text, dialect).unwrap_or_else(|errors| {
        let errors: Vec<String> = errors.iter().map(ToString::to_string).collect();
        panic!("{}\n{text}", errors.join("\n"))
    })
}

fn block(variables: &str, statements: &str) -> String {
    format!("FUNCTION_BLOCK Main VAR {variables} END_VAR {statements} END_FUNCTION_BLOCK")
}

/// Runs statements once; `x` is then the value.
#[track_caller]
fn check(dialect: Dialect, variables: &str, statements: &str, expected: i128) {
    let unit = unit(dialect, &block(variables, statements));
    let mut instance = unit.instance("Main").expect("it is there");
    instance.call().unwrap_or_else(|error| panic!("{error}"));
    let x = instance.get("x").expect("it is there");
    let value = x.as_int().or(x.as_bool().map(i128::from));
    assert_eq!(value, Some(expected), "{statements}");
}

/// Runs statements once, which stop with this message.
#[track_caller]
fn stops(dialect: Dialect, variables: &str, statements: &str, message: &str) {
    let unit = unit(dialect, &block(variables, statements));
    let mut instance = unit.instance("Main").expect("it is there");
    instance.set_limit(10_000);
    let error = instance.call().expect_err("it stops");
    assert!(error.message.contains(message), "{error}");
}

#[test]
fn arithmetic_and_precedence() {
    check(Edition2, "x : INT;", "x := 2 + 3 * 4 - 10 / 3;", 11);
    check(Edition2, "x : INT; a : INT := 7;", "x := a MOD 4 * 2;", 6);
    check(Edition2, "x : INT; a : INT := 7;", "x := -a + 2;", -5);
    check(Edition2, "x : INT; a : INT := 7;", "x := a -2;", 5);
    check(Edition2, "x : INT; a : INT := -7;", "x := a / 2;", -3);
    check(Edition2, "x : BOOL; a : INT := 7;", "x := a > 5 AND a < 8;", 1);
    check(Edition2, "x : BOOL; a, b : BOOL;", "x := NOT a AND b OR TRUE XOR a;", 1);
    check(Edition2, "x : BOOL; a : BOOL := TRUE; b : BOOL;", "x := NOT a = b;", 1);
    check(Edition2, "x : BOOL; a : INT := 1;", "x := a = 1 & a <> 2;", 1);
}

#[test]
fn integers_wrap_around() {
    check(Edition2, "x : USINT; a : USINT := 200;", "x := a + 100;", 44);
    check(Edition2, "x : INT; a : INT := 32767;", "x := a + 1;", -32768);
    check(Edition2, "x : UDINT; a : UDINT;", "x := a - 1;", 4_294_967_295);
    check(Edition2, "x : ULINT; a : ULINT;", "x := a - 1;", 18_446_744_073_709_551_615);
    check(Edition2, "x : BOOL; a : ULINT;", "x := a - 1 > a;", 1);
    check(Edition2, "x : SINT;", "x := -128; x := -x;", -128);
    check(Edition2, "x : WORD := 16#00F0;", "x := NOT x;", 0xFF0F);
    let unit =
        unit(Edition2, &block("a : USINT := 200; b : UINT;", "a := a + 100; b := 16#FFFF; b := b / 2;"));
    let stats = unit.instance("Main").expect("it is there").call().expect("it runs");
    assert_eq!(stats.wrapped, 1);
}

#[test]
fn conversions() {
    check(Edition2, "x : UDINT; a : USINT := 200;", "x := USINT_TO_UDINT(a);", 200);
    check(Edition2, "x : USINT; a : UINT := 300;", "x := UINT_TO_USINT(a);", 44);
    check(Edition2, "x : INT; a : BOOL := TRUE;", "x := BOOL_TO_INT(a);", 1);
    check(Edition2, "x : UINT; a : DWORD := 16#12345678;", "x := DWORD_TO_UINT(a AND 16#FFFF);", 0x5678);
    check(Edition2, "x : DINT; t2 : TIME := T#1m2s;", "x := TIME_TO_DINT(t2);", 62_000);
    check(Codesys, "x : UINT; a : USINT := 9;", "x := TO_UINT(a);", 9);
    check(Edition2, "x : INT; t1 : STRING[9] := '00123';", "x := STRING_TO_INT(MID(t1, 2, 4));", 23);
    stops(Edition2, "x : INT; t1 : STRING[9] := 'a';", "x := STRING_TO_INT(t1);", "`a` is no `INT`");
}

#[test]
fn standard_functions() {
    check(Edition2, "x : INT; a : INT := 5;", "x := MAX(a, 3, 9) + MIN(a, 3) * ABS(-2);", 15);
    check(Edition2, "x : INT; a : INT := 5;", "x := LIMIT(1, a, 3);", 3);
    check(Edition2, "x : INT; a : INT := 5;", "x := LIMIT(MN := 7, IN := a, MX := 9);", 7);
    check(Edition2, "x : INT; a : BOOL := TRUE;", "x := SEL(a, 3, 4);", 4);
    check(Edition2, "x : INT; a : INT := 2;", "x := MUX(a, 10, 20, 30);", 30);
    stops(Edition2, "x : INT; a : INT := 3;", "x := MUX(a, 10, 20, 30);", "there is no choice 3");
    check(Edition2, "x : DWORD := 16#1234_5678;", "x := SHR(x, 8) AND 16#FF;", 0x56);
    check(Edition2, "x : DWORD := 1;", "x := SHL(IN := x, N := 31);", 0x8000_0000);
    check(Edition2, "x : BYTE := 16#81;", "x := ROL(x, 1);", 3);
    check(Edition2, "x : WORD := 1;", "x := ROR(x, 1);", 0x8000);
    check(Codesys, "x : DINT; a : ARRAY [0..3] OF UINT;", "x := SIZEOF(a) / SIZEOF(a[0]) - 1;", 3);
    check(
        Edition2,
        "x : INT; t1 : STRING;",
        "t1 := CONCAT('ab', LEFT('cde', 2), RIGHT('fg', 1)); x := LEN(t1);",
        5,
    );
    check(Edition2, "x : BOOL; t1 : STRING;", "t1 := CONCAT('ab', 'c'); x := t1 = 'abc';", 1);
}

#[test]
fn branches() {
    let chain = "IF a = 1 THEN x := 10; ELSIF a = 2 THEN x := 20; ELSE x := 30; END_IF;";
    for (a, expected) in [(1, 10), (2, 20), (3, 30)] {
        check(Edition2, &format!("x : INT; a : INT := {a};"), chain, expected);
    }
    let cases = "CASE a OF 1: x := 1; 2, 5..7: x := 2; -3: x := 3; ELSE x := 4; END_CASE;";
    for (a, expected) in [(1, 1), (2, 2), (3, 4), (5, 2), (7, 2), (8, 4), (-3, 3), (0, 4)] {
        check(Edition2, &format!("x : INT; a : INT := {a};"), cases, expected);
    }
}

#[test]
fn loops() {
    check(Edition2, "x : INT; i : INT;", "FOR i := 1 TO 4 DO x := x + i; END_FOR;", 10);
    check(Edition2, "x : INT; i : INT;", "FOR i := 5 TO 1 BY -2 DO x := x * 10 + i; END_FOR;", 531);
    check(Edition2, "x : INT; i : INT;", "FOR i := 5 TO 1 DO x := 9; END_FOR;", 0);
    check(Edition2, "x : INT;", "WHILE x < 5 DO x := x + 2; END_WHILE;", 6);
    check(Edition2, "x : INT := 9;", "REPEAT x := x + 1; UNTIL TRUE END_REPEAT;", 10);
    check(Edition2, "x : INT;", "WHILE TRUE DO x := x + 1; IF x = 3 THEN EXIT; END_IF; END_WHILE;", 3);
    check(
        Codesys,
        "x : INT; i : INT;",
        "FOR i := 1 TO 4 DO IF i = 2 THEN CONTINUE; END_IF; x := x + i; END_FOR",
        8,
    );
    check(Edition2, "x : INT;", "WHILE TRUE DO x := x + 1; IF x = 3 THEN RETURN; END_IF; END_WHILE;", 3);
    check(
        Edition2,
        "x : INT; i, j : INT;",
        "FOR i := 0 TO 2 DO FOR j := 0 TO 9 DO IF j = 2 THEN EXIT; END_IF; x := x + 1; END_FOR; END_FOR;",
        6,
    );
    stops(
        Edition2,
        "i : USINT; x : INT;",
        "FOR i := 0 TO 255 DO x := 1; END_FOR;",
        "the control variable leaves `USINT`",
    );
    stops(Edition2, "x : BOOL;", "WHILE NOT x DO ; END_WHILE;", "too many statements");
}

#[test]
fn arrays() {
    check(
        Edition2,
        "x : INT; a : ARRAY [1..3] OF INT := [5, 6, 7]; i : INT := 2;",
        "x := a[i] * 10 + a[i + 1];",
        67,
    );
    check(
        Edition2,
        "x : INT; a : ARRAY [0..7] OF INT := [1, 3(2), 2(7, 8)];",
        "x := a[3] * 100 + a[4] * 10 + a[5];",
        278,
    );
    check(Edition2, "x : INT; a : ARRAY [0..4] OF INT := [1];", "x := a[0] * 10 + a[4];", 10);
    check(
        Edition2,
        "x : INT; a : ARRAY [0..1, 1..3] OF INT := [1, 2, 3, 4, 5, 6]; i : INT := 1;",
        "x := a[i, i + 1] * 10 + a[0, 3];",
        53,
    );
    check(
        Edition2,
        "x : INT; a : ARRAY [0..1] OF ARRAY [0..2] OF INT; i : INT := 1;",
        "a[i][2] := 4; x := a[1][i + 1];",
        4,
    );
    for (index, limit) in [(4, "index 4 is outside of [1..3]"), (0, "index 0 is outside of [1..3]")] {
        let variables = format!("x : INT; a : ARRAY [1..3] OF INT; i : INT := {index};");
        stops(Edition2, &variables, "x := a[i];", limit);
        stops(Edition2, &variables, "a[i] := 1;", limit);
    }
    stops(Edition2, "x : INT; y : INT;", "x := 1 / y;", "division by zero");
    stops(Edition2, "x : INT (0..5); y : INT := 6;", "x := y;", "6 is not within 0..5");
}

#[test]
fn errors_have_a_place() {
    let text = "FUNCTION_BLOCK Main\nVAR\n  a : ARRAY [0..1] OF INT;\n  i : INT := 2;\nEND_VAR\n  i := 2;\n  a[i] := 1;\nEND_FUNCTION_BLOCK";
    let unit = unit(Edition2, text);
    let error = unit.instance("Main").expect("it is there").call().expect_err("it stops");
    assert_eq!((error.line, error.column), (7, 5));
}

const TYPES: &str = "TYPE
  Colour : (Red, Green, Blue) := Green;
  Point : STRUCT x : INT := 1; y : ARRAY [0..1] OF INT; END_STRUCT;
  Row : ARRAY [0..2] OF INT;
END_TYPE
";

#[test]
fn named_types() {
    let text = TYPES.to_owned()
        + &block(
            "c : Colour; p1, q : Point := (x := 7); r2, s2 : Row; x : INT; points : ARRAY [0..1] OF Point; i : INT := 1;",
            "IF c = Green THEN c := Blue; END_IF; p1.y[1] := 5; q := p1; r2[2] := 3; s2 := r2; points[i].y[1] := 4;
             points[0] := q; x := q.x * 1000 + q.y[1] * 100 + s2[2] * 10 + points[1].y[i];",
        );
    let unit = unit(Edition2, &text);
    let mut instance = unit.instance("mAIN").expect("names have no case");
    instance.call().expect("it runs");
    assert_eq!(instance.int("x"), Ok(7534));
    assert_eq!(instance.int("c"), Ok(2));
    assert_eq!(instance.int("points[0].y[1]"), Ok(5));
    assert_eq!(instance.int("POINTS[1].X"), Ok(1));
}

const COUNTER: &str = "
FUNCTION_BLOCK Counter
VAR_INPUT up : BOOL := TRUE; rise : INT := 1; END_VAR
VAR_OUTPUT count : INT; END_VAR
VAR_IN_OUT total : INT; END_VAR
VAR_TEMP before : INT; END_VAR
  before := before + count;
  IF up THEN count := before + rise; END_IF;
  total := total + 1;
END_FUNCTION_BLOCK
";

#[test]
fn function_blocks_keep_their_variables() {
    let text = COUNTER.to_owned()
        + &block(
            "a, b : Counter; x, y : INT; k : ARRAY [0..1] OF INT; i : INT := 1;",
            "a(total := k[i]); a(rise := 10, total := k[1], count => x); b(up := FALSE, total := k[0]);
             b(total := k[i]); y := b.count;",
        );
    let unit = unit(Edition2, &text);
    let mut instance = unit.instance("Main").expect("it is there");
    instance.call().expect("it runs");
    assert_eq!((instance.int("x"), instance.int("y")), (Ok(11), Ok(0)));
    assert_eq!((instance.int("k[0]"), instance.int("k[1]")), (Ok(1), Ok(3)));
    instance.call().expect("it runs");
    // The inputs of the first call are kept as well.
    assert_eq!(instance.int("x"), Ok(31));
    assert_eq!(instance.int("a.count"), Ok(31));
    assert!(unit.instance("Counter").is_err(), "there is nothing for `total`");
}

#[test]
fn functions_forget_theirs() {
    let text = "
FUNCTION Sum : INT
VAR_INPUT a : INT; b : INT := 5; END_VAR VAR_OUTPUT twice : INT; END_VAR VAR k : INT := 1; END_VAR
  k := k + a; Sum := k + b; twice := 2 * Sum;
END_FUNCTION
FUNCTION Outer : INT VAR_INPUT a : INT; END_VAR Outer := Sum(a := Sum(a := a)) + Sum(1, 1); END_FUNCTION
"
    .to_owned()
        + &block("x, y : INT;", "x := Outer(10); x := x + Sum(a := 1, twice => y);");
    let unit = unit(Edition2, &text);
    let mut instance = unit.instance("Main").expect("it is there");
    instance.call().expect("it runs");
    assert_eq!((instance.int("x"), instance.int("y")), (Ok(22 + 3 + 7), Ok(14)));
    let mut alone = unit.instance("Sum").expect("it is there");
    alone.set("a", 3).expect("an input");
    for _ in 0..2 {
        let stats = alone.call().expect("it runs");
        assert_eq!((alone.int("Sum"), stats.statements), (Ok(9), 3));
    }
}

/// One search for all tables, as CODESYS and TwinCAT allow it.
const SEARCH: &str = "
FUNCTION Search : BOOL
VAR_INPUT
  table : POINTER TO ARRAY [0..65535] OF UINT; // of any length
  last, key : UINT;
END_VAR
VAR_IN_OUT row : UINT; END_VAR
VAR low, high, middle : UINT; END_VAR
  high := last;
  WHILE low < high DO
    middle := low + (high - low) / 2;
    IF table^[middle] < key THEN low := middle + 1; ELSE high := middle; END_IF
  END_WHILE
  row := low;
  Search := table^[low] = key;
END_FUNCTION
FUNCTION_BLOCK Lookup
VAR_INPUT key, last : UINT; END_VAR
VAR_OUTPUT found : BOOL; row : UINT; END_VAR
VAR CONSTANT keys : ARRAY [0..4] OF UINT := [2, 3, 5, 7, 11]; END_VAR
VAR table : POINTER TO ARRAY [0..65535] OF UINT; END_VAR
  table := ADR(keys);
  found := Search(table := table, last := last, key := key, row := row);
END_FUNCTION_BLOCK
";

#[test]
fn pointers_to_tables() {
    let unit = unit(Codesys, SEARCH);
    let mut lookup = unit.instance("Lookup").expect("it is there");
    lookup.set("last", 4).expect("an input");
    for (key, found, row) in [(2, true, 0), (7, true, 3), (11, true, 4), (4, false, 2), (12, false, 4)] {
        lookup.set("key", key).expect("an input");
        lookup.call().expect("it runs");
        assert_eq!((lookup.bool("found"), lookup.int("row")), (Ok(found), Ok(row)), "{key}");
    }
    lookup.set("last", 20).expect("an input");
    let error = lookup.call().expect_err("the table ends before");
    assert!(error.message.contains("outside of what the pointer points to"), "{error}");
}

#[test]
fn pointers_are_checked() {
    let variables = "x : UINT; a : ARRAY [0..3] OF UINT := [1, 2, 3, 4]; q : POINTER TO UINT; i : INT;";
    check(Codesys, variables, "q := ADR(a); x := q[3] + q^;", 5);
    check(Codesys, variables, "q := ADR(a[1]); q^ := 9; x := a[1];", 9);
    stops(Codesys, variables, "x := q^;", "points to nothing");
    stops(Codesys, variables, "q := ADR(a); x := q[4];", "less lies behind the pointer");
    stops(Codesys, variables, "q := ADR(a); i := -1; x := q[i];", "outside of what the pointer points to");
    let variables = "a : UINT; p : POINTER TO UINT; old : BOOL; x : UINT;";
    let unit_of_two =
        unit(Codesys, &block(variables, "IF NOT old THEN p := ADR(a); END_IF; x := p^; old := TRUE;"));
    let mut instance = unit_of_two.instance("Main").expect("it is there");
    instance.call().expect("the pointer is new");
    let error = instance.call().expect_err("the pointer is old");
    assert!(error.message.contains("taken in an earlier call"), "{error}");
    let text = "FUNCTION_BLOCK Main VAR CONSTANT c : UINT := 1; END_VAR VAR p : POINTER TO UINT; END_VAR
                p := ADR(c); p^ := 2; END_FUNCTION_BLOCK";
    let unit = unit(Codesys, text);
    let error = unit.instance("Main").expect("it is there").call().expect_err("it is constant");
    assert!(error.message.contains("a constant is written"), "{error}");
}

#[test]
fn short_circuits_stop_early() {
    let variables = "x : BOOL; a : ARRAY [0..1] OF BOOL; i : INT := 5;";
    check(Codesys, variables, "x := i < 2 AND_THEN a[i];", 0);
    check(Codesys, variables, "x := i > 2 OR_ELSE a[i];", 1);
    stops(Codesys, variables, "x := i < 2 AND a[i];", "index 5");
}

#[test]
fn strings_hold_tables() {
    // Codes 0 to 61 as letters, from the first character on.
    check(Codesys, "x : BYTE; s : STRING[5] := 'AB$$C'; i : INT := 2;", "x := s[i];", 36);
    check(Codesys, "x : BYTE; s : STRING[5] := 'AB';", "x := s[2];", 0);
    check(Siemens, "x : INT; s : STRING[5] := 'AB'; i : INT := 2;", "x := CHAR_TO_INT(s[i]);", 66);
    check(Edition2, "x : INT; t1 : STRING[3];", "t1 := 'abcdef'; x := LEN(t1);", 3);
    stops(
        Edition2,
        "t1 : STRING[3] := 'abc';",
        "t1 := MID(t1, 2, 3);",
        "2 characters from 3 on: there are 3",
    );
}

/// What `Q` is after each step of 100 ms.
fn timer(name: &str, inputs: &[bool]) -> Vec<bool> {
    let text = format!(
        "FUNCTION_BLOCK Main VAR_INPUT i : BOOL; END_VAR VAR_OUTPUT o : BOOL; e : TIME; END_VAR VAR clock : {name}; END_VAR
         clock(IN := i, PT := T#200ms); o := clock.Q; e := clock.ET; END_FUNCTION_BLOCK"
    );
    let unit = unit(Edition2, &text);
    let mut instance = unit.instance("Main").expect("it is there");
    let mut outputs = Vec::new();
    for input in inputs {
        instance.set("i", *input).expect("an input");
        let stats = instance.call().expect("it runs");
        assert_eq!(stats.statements, 3, "those of the timer do not count");
        outputs.push(instance.bool("o").expect("an output"));
        instance.advance(Duration::from_millis(100));
    }
    outputs
}

#[test]
fn timers() {
    let inputs = [true, true, true, true, false, false, false, false];
    assert_eq!(timer("TON", &inputs), [false, false, true, true, false, false, false, false]);
    assert_eq!(timer("TOF", &inputs), [true, true, true, true, true, true, false, false]);
    assert_eq!(timer("TP", &inputs), [true, true, false, false, false, false, false, false]);
    assert_eq!(timer("TON", &[true, false, true, true, true]), [false, false, false, false, true]);
    assert_eq!(timer("TP", &[true, false, false, true, false]), [true, true, false, true, true]);
}

/// The value of an expression after each pair of inputs.
fn latch(dialect: Dialect, declaration: &str, call: &str, inputs: &[(bool, bool)]) -> Vec<bool> {
    let text = format!(
        "FUNCTION_BLOCK Main VAR_INPUT i, j : BOOL; END_VAR VAR_OUTPUT o : BOOL; END_VAR VAR f : {declaration}; END_VAR
         {call} END_FUNCTION_BLOCK"
    );
    let unit = unit(dialect, &text);
    let mut instance = unit.instance("Main").expect("it is there");
    let step = |(i, j): &(bool, bool)| {
        instance.set("i", *i).expect("an input");
        instance.set("j", *j).expect("an input");
        instance.call().expect("it runs");
        instance.bool("o").expect("an output")
    };
    inputs.iter().map(step).collect()
}

#[test]
fn edges_and_latches() {
    let edges = [(false, false), (true, false), (true, false), (false, false), (true, false)];
    let rises = latch(Edition2, "R_TRIG", "f(CLK := i, Q => o);", &edges);
    assert_eq!(rises, [false, true, false, false, true]);
    let falls = latch(Edition2, "F_TRIG", "f(CLK := i, Q => o);", &edges);
    assert_eq!(falls, [false, false, false, true, false]);
    let both = [(true, true), (false, false), (true, false), (false, false), (false, true)];
    assert_eq!(latch(Edition2, "SR", "f(S1 := i, R := j, Q1 => o);", &both), [true, true, true, true, false]);
    assert_eq!(
        latch(Edition2, "RS", "f(S := i, R1 := j, Q1 => o);", &both),
        [false, false, true, true, false]
    );
    assert_eq!(
        latch(Codesys, "SR", "f(SET1 := i, RESET := j, Q1 => o);", &both),
        [true, true, true, true, false]
    );
}

#[test]
fn a_scan_runs_all_programs() {
    let text = "
PROGRAM Adds VAR_EXTERNAL shared : INT; END_VAR VAR seen : INT; END_VAR shared := shared + 1; seen := shared; END_PROGRAM
CONFIGURATION Config0
  VAR_GLOBAL shared : INT := 5; END_VAR
  RESOURCE Res0 ON PLC
    TASK Cyclic(INTERVAL := T#10ms, PRIORITY := 1);
    PROGRAM First WITH Cyclic : Adds;
    PROGRAM Second WITH Cyclic : Adds;
  END_RESOURCE
END_CONFIGURATION";
    let unit = unit(Edition2, text);
    let mut configuration = unit.configuration().expect("there is one");
    configuration.call().expect("it runs");
    assert_eq!(configuration.int("First.seen"), Ok(6));
    assert_eq!(configuration.int("second.SEEN"), Ok(7));
    assert_eq!(configuration.int("shared"), Ok(7));
    assert_eq!(unit.names().collect::<Vec<_>>(), ["Adds"]);
    let [task] = unit.tasks() else { panic!("{:?}", unit.tasks()) };
    assert_eq!((task.name.as_str(), task.interval), ("Cyclic", Some(Duration::from_millis(10))));
    assert_eq!((task.priority, &task.programs[..]), (1, &["First".to_owned(), "Second".to_owned()][..]));
}

const SCL: &str = "
TYPE \"Pair\"
VERSION : 0.1
  STRUCT
    first : Int := 3;
    second : Array[0..2] of Bool;
  END_STRUCT;
END_TYPE
FUNCTION \"Twice\" : Int
{ S7_Optimized_Access := 'TRUE' }
VERSION : 0.1
  VAR_INPUT value : Int; END_VAR
BEGIN
  #Twice := 2 * #value; // shifted
END_FUNCTION
FUNCTION \"Note\" : Void
  VAR_IN_OUT count : Int; END_VAR
BEGIN
  #count := #count + 1;
END_FUNCTION
FUNCTION_BLOCK \"Machine\"
TITLE = a machine
  VAR_INPUT go : Bool; END_VAR
  VAR_OUTPUT result : Int; END_VAR
  VAR
    pair : \"Pair\";
    \"Limit\" : Int := 10;
    source : Array[0..3] of USInt := [1, 2, 2(9)];
    notes : Int;
    delay : TON_TIME;
  END_VAR
  VAR CONSTANT most : Int := 20; END_VAR
  VAR_TEMP index : Int; END_VAR
BEGIN
  REGION work
    FOR #index := 0 TO 3 DO
      IF #go AND (#source[#index] = 9) THEN
        #result := \"Twice\"(#pair.first) + #most;
        \"Note\"(count := #notes);
        CONTINUE;
      END_IF;
    END_FOR;
    #delay(IN := #go, PT := T#1s);
  END_REGION
END_FUNCTION_BLOCK
DATA_BLOCK \"Machine_DB\"
VERSION : 0.1
\"Machine\"
BEGIN
END_DATA_BLOCK
ORGANIZATION_BLOCK \"Main\"
BEGIN
  \"Machine_DB\"(go := TRUE);
END_ORGANIZATION_BLOCK
";

#[test]
fn scl() {
    let unit = unit(Siemens, SCL);
    let mut main = unit.instance("Main").expect("it is there");
    main.call().expect("it runs");
    assert_eq!(main.int("Machine_DB.result"), Ok(26));
    assert_eq!(main.int("Machine_DB.notes"), Ok(2));
    assert_eq!(main.int("Machine_DB.Limit"), Ok(10));
}

#[test]
fn costs_are_counted() {
    let text = block(
        "a : ARRAY [0..7] OF INT; i : INT; x : INT;",
        "FOR i := 0 TO 7 DO a[i] := i; END_FOR; x := a[3]; IF a[x] = x THEN x := a[x]; END_IF;",
    );
    let unit = unit(Edition2, &text);
    let stats = unit.instance("Main").expect("it is there").call().expect("it runs");
    assert_eq!(
        (stats.statements, stats.iterations, stats.indexed, stats.compared, stats.calls),
        (1 + 8 + 1 + 1 + 1, 8, 10, 1, 0)
    );
}

#[test]
fn copies_are_counted() {
    let text = TYPES.to_owned()
        + "FUNCTION Last : INT VAR_INPUT values : Row; END_VAR Last := values[2]; END_FUNCTION "
        + &block("a, b : Row; x : INT;", "a[2] := 4; b := a; x := Last(b); x := Last(values := b);");
    let unit = unit(Edition2, &text);
    let mut instance = unit.instance("Main").expect("it is there");
    let stats = instance.call().expect("it runs");
    assert_eq!((stats.copied, stats.calls, instance.int("x")), (9, 2, Ok(4)));
}

fn touch(instance: &mut Instance<'_>, path: &str, value: impl Into<Value>) -> bool {
    instance.set(path, value).is_ok()
}

#[test]
fn a_power_cycle_leaves_what_is_retained() {
    let text = "
    FUNCTION_BLOCK Inner
    VAR RETAIN kept : INT; list : ARRAY [0..1] OF BOOL; END_VAR
    VAR lost : INT; END_VAR
    VAR NON_RETAIN lost_too : INT; END_VAR
      kept := kept + 1; lost := lost + 1; lost_too := lost_too + 1; list[1] := TRUE;
    END_FUNCTION_BLOCK
    FUNCTION_BLOCK Outer
    VAR one : Inner; END_VAR
    VAR RETAIN two : Inner; END_VAR
    VAR count : INT; END_VAR
      one(); two(); count := count + 1;
    END_FUNCTION_BLOCK
    PROGRAM Main VAR own : Outer; END_VAR own(); END_PROGRAM
    CONFIGURATION Config
      RESOURCE Res ON PLC TASK Cyclic(INTERVAL := T#1ms, PRIORITY := 1); PROGRAM Main0 WITH Cyclic : Main; END_RESOURCE
    END_CONFIGURATION";
    let unit = unit(Edition2, text);
    let mut before = unit.configuration().expect("it is there");
    before.call().expect("it runs");
    before.call().expect("it runs");
    let mut after = unit.configuration().expect("it is there");
    let retained = before.retained();
    let paths: Vec<&str> = retained.iter().map(|(path, _)| path.as_str()).collect();
    let one = ["kept", "list"].map(|name| format!("Main0.own.one.{name}"));
    let two = ["kept", "list", "lost", "lost_too"].map(|name| format!("Main0.own.two.{name}"));
    assert_eq!(paths, [&one[..], &two[..]].concat());
    for (path, value) in retained {
        after.set(&path, value).expect("it is there");
    }
    after.call().expect("it runs");
    let numbers = ["own.one.kept", "own.one.lost", "own.two.kept", "own.two.lost", "own.count"]
        .map(|path| after.int(&format!("Main0.{path}")));
    assert_eq!(numbers, [3, 1, 3, 3, 1].map(Ok));
}

#[test]
fn values_from_outside_are_checked() {
    let text = block("a : USINT; b : BOOL; t1 : STRING[2]; r2 : ARRAY [0..1] OF INT; t2 : TIME;", ";")
        .replace("VAR a", "VAR CONSTANT c : INT := 1; END_VAR VAR a");
    let unit = unit(Edition2, &text);
    let instance = &mut unit.instance("Main").expect("it is there");
    assert!(touch(instance, "a", 255) && !touch(instance, "a", 256) && !touch(instance, "a", true));
    assert!(touch(instance, "b", true) && !touch(instance, "b", 1));
    assert!(touch(instance, "t1", "ab") && !touch(instance, "t1", "abc"));
    assert!(touch(instance, "r2[1]", 3) && !touch(instance, "r2[2]", 3) && !touch(instance, "r2.x", 3));
    assert!(
        touch(instance, "t2", Duration::from_secs(1)) && !touch(instance, "c", 2) && !touch(instance, "z", 2)
    );
    assert_eq!(instance.get("r2"), Ok(Value::Array(vec![Value::Int(0), Value::Int(3)])));
    assert_eq!(instance.get("t2"), Ok(Value::Time(1_000_000_000)));
}

/// Tables of 30,000 entries, and the binary search over them.
#[test]
fn large_tables() {
    let numbers = |step: u32| (0..30_000).map(|n| (n * step).to_string()).collect::<Vec<_>>().join(", ");
    let text = format!(
        "FUNCTION_BLOCK Main
         VAR_INPUT key : UDINT; END_VAR VAR_OUTPUT value : UDINT; END_VAR
         VAR CONSTANT
           source : ARRAY [0..29999] OF UDINT := [{}];
           target : ARRAY [0..29999] OF UDINT := [{}];
         END_VAR
         VAR low, high, middle : UDINT; END_VAR
         low := 0; high := 29999;
         WHILE low < high DO
           middle := (low + high) / 2;
           IF source[middle] < key THEN low := middle + 1; ELSE high := middle; END_IF;
         END_WHILE;
         value := target[low];
         END_FUNCTION_BLOCK",
        numbers(3),
        numbers(7),
    );
    let unit = unit(Edition2, &text);
    let mut instance = unit.instance("Main").expect("it is there");
    for row in (0..30_000).step_by(97) {
        instance.set("key", row * 3).expect("an input");
        let stats = instance.call().expect("it runs");
        assert_eq!(instance.int("value"), Ok(i128::from(row * 7)));
        assert!(stats.iterations <= 15 && stats.indexed == stats.iterations + 1, "{stats:?}");
    }
}

/// A machine of as many states as branches.
#[test]
fn large_cases() {
    let states: u32 = 3017;
    let branch = |s: u32| {
        let (yes, no) = (s * 7 % states, s * 3 % states);
        format!("{s}: IF go THEN state := {yes}; ELSE state := {no}; END_IF;\n")
    };
    let branches: String = (0..states).map(branch).collect();
    let text = format!(
        "FUNCTION_BLOCK Main VAR_INPUT go : BOOL; END_VAR VAR_OUTPUT state : UINT := 1; END_VAR
         CASE state OF {branches} END_CASE; END_FUNCTION_BLOCK"
    );
    let unit = unit(Edition2, &text);
    let mut instance = unit.instance("Main").expect("it is there");
    let mut state = 1;
    for call in 0..20_000 {
        instance.set("go", call % 3 == 0).expect("an input");
        instance.call().expect("it runs");
        state = state * if call % 3 == 0 { 7 } else { 3 } % states;
        assert_eq!(instance.int("state"), Ok(state.into()));
    }
}
