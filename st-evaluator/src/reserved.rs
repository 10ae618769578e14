//! Words that no variable, type or block may be called.

use std::collections::BTreeSet;

use crate::dialect::Dialect;

/// IEC 61131-3:2003, annex C: keywords, types, operators, standard functions and function blocks.
const EDITION_2: &str = "
ACTION END_ACTION ARRAY OF AT CASE ELSE END_CASE CONFIGURATION END_CONFIGURATION CONSTANT EN ENO EXIT FALSE F_EDGE
FOR TO BY DO END_FOR FUNCTION END_FUNCTION FUNCTION_BLOCK END_FUNCTION_BLOCK IF THEN ELSIF END_IF INITIAL_STEP
END_STEP NOT MOD AND XOR OR PROGRAM END_PROGRAM R_EDGE READ_ONLY READ_WRITE REPEAT UNTIL END_REPEAT RESOURCE ON
END_RESOURCE RETAIN NON_RETAIN RETURN STEP STRUCT END_STRUCT TASK TRANSITION FROM END_TRANSITION TRUE TYPE END_TYPE
VAR END_VAR VAR_INPUT VAR_OUTPUT VAR_IN_OUT VAR_TEMP VAR_EXTERNAL VAR_ACCESS VAR_CONFIG VAR_GLOBAL WHILE END_WHILE
WITH INTERVAL SINGLE PRIORITY
BOOL SINT INT DINT LINT USINT UINT UDINT ULINT REAL LREAL TIME DATE TIME_OF_DAY TOD DATE_AND_TIME DT STRING WSTRING
BYTE WORD DWORD LWORD ANY ANY_DERIVED ANY_ELEMENTARY ANY_MAGNITUDE ANY_NUM ANY_REAL ANY_INT ANY_BIT ANY_STRING
ANY_DATE
LD LDN ST STN ANDN ORN XORN ADD SUB MUL DIV GT GE EQ NE LE LT JMP JMPC JMPCN CAL CALC CALCN RET RETC RETCN
ABS SQRT LN LOG EXP SIN COS TAN ASIN ACOS ATAN EXPT MOVE SHL SHR ROR ROL SEL MAX MIN LIMIT MUX LEN LEFT RIGHT MID
CONCAT INSERT DELETE REPLACE FIND TRUNC ADD_TIME ADD_TOD_TIME ADD_DT_TIME SUB_TIME SUB_DATE_DATE SUB_TOD_TIME
SUB_TOD_TOD SUB_DT_TIME SUB_DT_DT MULTIME DIVTIME CONCAT_DATE_TOD
SR RS SEMA R_TRIG F_TRIG CTU CTD CTUD TP TON TOF RTC
";

/// Operators of instruction lists and qualifiers of actions, which only the standard keeps everywhere.
const QUALIFIERS: &str = "N R S L D P SD DS SL";

/// What CODESYS and TwinCAT keep beyond that.
const CODESYS: &str = "
ABSTRACT ADR AND_THEN BITADR BIT CHAR CONTINUE EXTENDS FINAL IMPLEMENTS INDEXOF INI INTERFACE END_INTERFACE INTERNAL
LDATE LDT LTIME LTOD METHOD END_METHOD NAMESPACE END_NAMESPACE OR_ELSE OVERRIDE PERSISTENT POINTER PRIVATE PROPERTY
END_PROPERTY PROTECTED PUBLIC REF REF_TO REFERENCE SIZEOF SUPER THIS UNION END_UNION USING VAR_INST VAR_STAT VAR_TEMP
WCHAR XSIZEOF GET SET
";

/// What SCL keeps beyond that; names in quotes or behind `#` are free.
const SCL: &str = "
ANY BEGIN BLOCK_DB BLOCK_FB BLOCK_FC BLOCK_SDB CHAR CONTINUE COUNTER DATA_BLOCK END_DATA_BLOCK END_LABEL
END_ORGANIZATION_BLOCK END_REGION GOTO LABEL LDT LTIME LTOD NIL ORGANIZATION_BLOCK POINTER REF_TO REGION S5TIME TIMER
VARIANT VOID WCHAR
";

/// Types on either side of a conversion function.
const CONVERTED: &str = "
BCD BOOL SINT INT DINT LINT USINT UINT UDINT ULINT REAL LREAL TIME DATE TIME_OF_DAY TOD DATE_AND_TIME DT STRING
WSTRING BYTE WORD DWORD LWORD
";

/// The words of a dialect.
#[derive(Debug)]
pub(crate) struct Reserved {
    words: BTreeSet<&'static str>,
    converted: BTreeSet<&'static str>,
}

impl Reserved {
    pub(crate) fn of(dialect: Dialect) -> Reserved {
        let further = match dialect {
            Dialect::Edition2 => QUALIFIERS,
            Dialect::Codesys | Dialect::TwinCat => CODESYS,
            Dialect::Siemens => SCL,
        };
        Reserved {
            words: EDITION_2.split_whitespace().chain(further.split_whitespace()).collect(),
            converted: CONVERTED.split_whitespace().collect(),
        }
    }

    /// Whether a name, in capitals, is taken. Conversions (`INT_TO_REAL`, `INT_TO_BCD_…`) are standard functions.
    pub(crate) fn has(&self, capitals: &str) -> bool {
        self.words.contains(capitals) || self.is_conversion(capitals)
    }

    fn is_conversion(&self, capitals: &str) -> bool {
        let is_type = |name: &str| self.converted.contains(name);
        capitals.match_indices("_TO_").any(|(at, between)| {
            let from = &capitals[..at];
            let to = &capitals[at + between.len()..];
            is_type(from) && is_type(to)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_differ_by_dialect() {
        let edition = Reserved::of(Dialect::Edition2);
        let codesys = Reserved::of(Dialect::Codesys);
        let scl = Reserved::of(Dialect::Siemens);
        for word in ["END_IF", "TON", "MUX", "ANY_INT", "INT_TO_REAL", "DATE_AND_TIME_TO_TOD"] {
            assert!(edition.has(word) && codesys.has(word) && scl.has(word), "{word}");
        }
        for word in ["ARM_TO_REAL", "INT_TO_ARM", "STATE", "Q1"] {
            assert!(!edition.has(word) && !codesys.has(word) && !scl.has(word), "{word}");
        }
        assert!(codesys.has("ADR") && !edition.has("ADR") && !scl.has("ADR"));
        assert!(scl.has("REGION") && !edition.has("REGION") && !codesys.has("REGION"));
    }
}
