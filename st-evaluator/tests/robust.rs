//! No text makes the evaluator panic: texts with words lost, doubled and exchanged are refused or run.

use st_evaluator::{Dialect, Unit};

const TEXTS: [&str; 3] = [
    "TYPE Colour : (Red, Green); Row : ARRAY [-1..2] OF INT; Point : STRUCT x : INT := 3; y : Row; END_STRUCT; END_TYPE
     FUNCTION Sum : INT VAR_INPUT a : INT; row2 : Row; END_VAR VAR_IN_OUT k : INT; END_VAR
       Sum := a + row2[2]; k := k * 2;
     END_FUNCTION
     FUNCTION_BLOCK Main
     VAR_INPUT go : BOOL; END_VAR VAR_OUTPUT x : INT; END_VAR
     VAR CONSTANT table : ARRAY [0..3] OF UINT := [1, 2(3), 4]; END_VAR
     VAR rises : BOOL; c : Colour; p1 : Point := (x := 4); i : INT; edge : R_TRIG; delay : TON; t1 : STRING[9] := 'a$'b'; END_VAR
       edge(CLK := go, Q => rises);
       CASE c OF Red: c := Green; ELSE c := Colour#Red; END_CASE;
       FOR i := 0 TO 3 BY 1 DO x := x + UINT_TO_INT(table[i]); IF x > 100 THEN EXIT; END_IF; END_FOR;
       REPEAT x := Sum(a := x, row2 := p1.y, k := i) MOD 7; UNTIL x < 3 OR NOT go END_REPEAT;
       delay(IN := go, PT := T#1s); t1 := MID(t1, 1, 2); p1.y[i - 5] := LEN(t1); x := SEL(go, MAX(x, 3), -x) / (i - 8);
     END_FUNCTION_BLOCK
     PROGRAM Run VAR m : Main; END_VAR m(go := TRUE); END_PROGRAM
     CONFIGURATION Config0 VAR_GLOBAL g : INT; END_VAR RESOURCE Res0 ON PLC
       TASK Cyclic(INTERVAL := T#10ms, PRIORITY := 1); PROGRAM Main0 WITH Cyclic : Run;
     END_RESOURCE END_CONFIGURATION",
    "FUNCTION Search : BOOL VAR_INPUT table : POINTER TO ARRAY [0..99] OF UINT; last : UINT; END_VAR
       Search := table^[last] = 3 AND_THEN table^[0] > 2;
     END_FUNCTION
     FUNCTION_BLOCK Main
     VAR a : ARRAY [0..4] OF UINT := [5(3)]; q : POINTER TO UINT; b : BOOL; w : WORD; t1 : STRING := 'abc'; END_VAR
       q := ADR(a[1]); q^ := q[1] + t1[1]; b := Search(ADR(a), SIZEOF(a) / 2 - 1) OR_ELSE b;
       w := SHL(w, 3) XOR ROL(w, q^); WHILE b DO b := FALSE; CONTINUE; END_WHILE
     END_FUNCTION_BLOCK",
    "FUNCTION \"Twice\" : Int VAR_INPUT value : Int; END_VAR BEGIN #Twice := 2 * #value; END_FUNCTION
     FUNCTION_BLOCK \"Main\" VAR source : Array[0..3] of USInt := [1, 2, 2(9)]; n : Int; t1 : String[4]; END_VAR BEGIN
     REGION work
       #n := \"Twice\"(#n) + CHAR_TO_INT(#t1[1]); #source[#n] := 3;
     END_REGION
     END_FUNCTION_BLOCK
     DATA_BLOCK \"Main_DB\" \"Main\" BEGIN END_DATA_BLOCK",
];

/// A reproducible source of numbers (xorshift).
fn next(state: &mut u64) -> usize {
    *state ^= *state << 13;
    *state ^= *state >> 7;
    *state ^= *state << 17;
    *state as usize
}

/// The words, numbers and signs of a text, with the spaces behind them.
fn pieces(text: &str) -> Vec<&str> {
    let mut pieces = Vec::new();
    let mut start = 0;
    let sort = |c: char| if c.is_alphanumeric() || c == '_' { 1 } else { 0 };
    for ((at, before), (_, after)) in text.char_indices().zip(text.char_indices().skip(1)) {
        if sort(before) == 0 || sort(after) == 0 {
            pieces.push(&text[start..at + before.len_utf8()]);
            start = at + before.len_utf8();
        }
    }
    pieces.push(&text[start..]);
    pieces
}

fn run(text: &str, dialect: Dialect) -> bool {
    let Ok(unit) = Unit::parse(text, dialect) else { return false };
    for name in unit.names() {
        let Ok(mut instance) = unit.instance(name) else { continue };
        instance.set_limit(1000);
        for _ in 0..3 {
            let _ = instance.call();
        }
    }
    if let Ok(mut configuration) = unit.configuration() {
        configuration.set_limit(1000);
        let _ = configuration.call();
    }
    true
}

#[test]
fn whole_texts_compile() {
    for (text, dialect) in TEXTS.into_iter().zip([Dialect::Edition2, Dialect::Codesys, Dialect::Siemens]) {
        assert_eq!(Unit::parse(text, dialect).err(), None);
        assert!(run(text, dialect));
    }
}

#[test]
fn nothing_panics() {
    let state = &mut 0x9E37_79B9_7F4A_7C15;
    let mut compiled = 0;
    for round in 0..600 {
        let text = TEXTS[round % TEXTS.len()];
        let mut pieces = pieces(text);
        for _ in 0..1 + next(state) % 2 {
            let (a, b) = (next(state) % pieces.len(), next(state) % pieces.len());
            match next(state) % 4 {
                0 => {
                    pieces.remove(a);
                }
                1 => pieces.insert(a, pieces[b]),
                2 => pieces[a] = pieces[b],
                _ => pieces.swap(a, b),
            }
        }
        let text = pieces.concat();
        for dialect in [Dialect::Edition2, Dialect::Codesys, Dialect::TwinCat, Dialect::Siemens] {
            compiled += usize::from(run(&text, dialect));
        }
    }
    assert!(compiled > 50, "only {compiled} still compile");
}
