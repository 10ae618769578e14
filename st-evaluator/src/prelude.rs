//! The standard function blocks, in Structured Text. Their statements are not counted.

use crate::dialect::Dialect;

/// Function blocks of every dialect. `__CLOCK` is the simulated time.
const COMMON: &str = "
FUNCTION_BLOCK R_TRIG
VAR_INPUT CLK : BOOL; END_VAR VAR_OUTPUT Q : BOOL; END_VAR VAR M : BOOL; END_VAR
Q := CLK AND NOT M; M := CLK;
END_FUNCTION_BLOCK
FUNCTION_BLOCK F_TRIG
VAR_INPUT CLK : BOOL; END_VAR VAR_OUTPUT Q : BOOL; END_VAR VAR M : BOOL := TRUE; END_VAR
Q := NOT CLK AND NOT M; M := NOT CLK;
END_FUNCTION_BLOCK
FUNCTION_BLOCK CTU
VAR_INPUT CU : BOOL; R : BOOL; PV : INT; END_VAR VAR_OUTPUT Q : BOOL; CV : INT; END_VAR VAR M : BOOL; END_VAR
IF R THEN CV := 0; ELSIF CU AND NOT M AND CV < 32767 THEN CV := CV + 1; END_IF; M := CU; Q := CV >= PV;
END_FUNCTION_BLOCK
";

/// Timers; `@` is what follows the name.
const TIMERS: &str = "
FUNCTION_BLOCK TON@
VAR_INPUT IN : BOOL; PT : TIME; END_VAR VAR_OUTPUT Q : BOOL; ET : TIME; END_VAR
VAR start : TIME; running : BOOL; END_VAR
IF IN THEN
  IF NOT running THEN start := __CLOCK(); running := TRUE; END_IF;
  ET := MIN(__CLOCK() - start, PT); Q := ET >= PT;
ELSE running := FALSE; Q := FALSE; ET := T#0s; END_IF;
END_FUNCTION_BLOCK
FUNCTION_BLOCK TOF@
VAR_INPUT IN : BOOL; PT : TIME; END_VAR VAR_OUTPUT Q : BOOL; ET : TIME; END_VAR
VAR start : TIME; running : BOOL; END_VAR
IF IN THEN running := FALSE; Q := TRUE; ET := T#0s;
ELSIF Q THEN
  IF NOT running THEN start := __CLOCK(); running := TRUE; END_IF;
  ET := MIN(__CLOCK() - start, PT); Q := ET < PT;
END_IF;
END_FUNCTION_BLOCK
FUNCTION_BLOCK TP@
VAR_INPUT IN : BOOL; PT : TIME; END_VAR VAR_OUTPUT Q : BOOL; ET : TIME; END_VAR
VAR start : TIME; M : BOOL; END_VAR
IF IN AND NOT M AND NOT Q AND ET = T#0s THEN start := __CLOCK(); Q := TRUE; END_IF;
IF Q THEN ET := MIN(__CLOCK() - start, PT); Q := ET < PT; END_IF;
IF NOT Q AND NOT IN THEN ET := T#0s; END_IF;
M := IN;
END_FUNCTION_BLOCK
";

/// Latches; `$S`, `$R`, `$D` and `$E` are the inputs, which the systems call differently.
const LATCHES: &str = "
FUNCTION_BLOCK SR
VAR_INPUT $D : BOOL; $R : BOOL; END_VAR VAR_OUTPUT Q1 : BOOL; END_VAR
Q1 := $D OR Q1 AND NOT $R;
END_FUNCTION_BLOCK
FUNCTION_BLOCK RS
VAR_INPUT $S : BOOL; $E : BOOL; END_VAR VAR_OUTPUT Q1 : BOOL; END_VAR
Q1 := (Q1 OR $S) AND NOT $E;
END_FUNCTION_BLOCK
";

/// The text that stands behind every other.
pub(crate) fn text(dialect: Dialect) -> String {
    let mut text = COMMON.to_owned() + &TIMERS.replace('@', "");
    let names = match dialect {
        Dialect::Edition2 => [("$D", "S1"), ("$R", "R"), ("$S", "S"), ("$E", "R1")],
        Dialect::Codesys | Dialect::TwinCat => {
            [("$D", "SET1"), ("$R", "RESET"), ("$S", "SET"), ("$E", "RESET1")]
        }
        // There they are instructions of the graphical languages only.
        Dialect::Siemens => return text + &TIMERS.replace('@', "_TIME"),
    };
    let latches = names.into_iter().fold(LATCHES.to_owned(), |text, (mark, name)| text.replace(mark, name));
    text.push_str(&latches);
    text
}
