//! Words that names must keep clear of, per language, and the conversion functions.
//!
//! Sources: IEC 61131-3:2003, annex C; the keyword pages of CODESYS and TwinCAT (with compiler error C0543, words
//! reserved for later) and their operators and standard libraries; the keywords, data types and basic instructions of SCL.

/// What a language keeps for itself. Case does not count.
pub(in crate::emit::st) struct Words {
    /// Lists of words in capitals, separated by white space.
    lists: &'static [&'static str],
    /// Types that stand on either side of a conversion function.
    converted: &'static [&'static str],
    /// Whether conversions may leave out the type on the left (`TO_INT`).
    overloaded: bool,
}

impl Words {
    /// Every word that is not a conversion, in capitals.
    pub(in crate::emit::st) fn iter(&self) -> impl Iterator<Item = &'static str> {
        self.lists.iter().flat_map(|list| list.split_ascii_whitespace())
    }

    /// Whether a name, given in capitals, is that of a conversion function: `X_TO_Y`, `X_BCD_TO_Y`, `X_TO_BCD_Y`,
    /// `X_TRUNC_Y`, and overloaded `TO_Y`, for elementary types X and Y.
    pub(in crate::emit::st) fn is_conversion(&self, capitals: &str) -> bool {
        let types = self.converted.iter().flat_map(|list| list.split_ascii_whitespace());
        let mut is_type = |name: &str| types.clone().any(|converted| converted == name);
        let overloaded = self.overloaded
            && ["TO_", "ANY_TO_"].iter().any(|to| capitals.strip_prefix(to).is_some_and(&mut is_type));
        overloaded
            || ["_TO_BCD_", "_BCD_TO_", "_TRUNC_", "_TO_"]
                .into_iter()
                .filter_map(|between| capitals.split_once(between))
                .any(|(from, to)| is_type(from) && is_type(to))
    }
}

/// The second edition of the standard.
pub(super) static EDITION2: Words =
    Words { lists: &[STANDARD], converted: &[STANDARD_TYPES], overloaded: false };

/// CODESYS 3.
pub(super) static CODESYS: Words =
    Words { lists: &[STANDARD, OF_CODESYS], converted: &[STANDARD_TYPES, LONG_TYPES], overloaded: true };

/// TwinCAT 3.
pub(super) static TWINCAT: Words = Words {
    lists: &[STANDARD, OF_CODESYS, OF_TWINCAT],
    converted: &[STANDARD_TYPES, LONG_TYPES],
    overloaded: true,
};

/// SCL in TIA Portal.
pub(super) static SCL: Words =
    Words { lists: &[STANDARD, OF_SCL], converted: &[STANDARD_TYPES, LONG_TYPES], overloaded: true };

/// Keywords, elementary types, operators of both textual languages, action qualifiers, standard functions and function
/// blocks with their formal parameters.
const STANDARD: &str = "
ABS ACOS ACTION ADD ADD_DT_TIME ADD_TIME ADD_TOD_TIME AND ANDN ANY ANY_BIT ANY_DATE ANY_DERIVED ANY_ELEMENTARY
ANY_INT ANY_MAGNITUDE ANY_NUM ANY_REAL ANY_STRING ARRAY ASIN AT ATAN BOOL BY BYTE CAL CALC CALCN CASE CD CLK
CONCAT CONCAT_DATE_TOD CONFIGURATION CONSTANT COS CTD CTD_DINT CTD_LINT CTD_UDINT CTD_ULINT CTU CTUD CTUD_DINT
CTUD_LINT CTUD_UDINT CTUD_ULINT CTU_DINT CTU_LINT CTU_UDINT CTU_ULINT CU CV D DATE DATE_AND_TIME DELETE DINT DIV
DIVTIME DO DS DT DWORD ELSE ELSIF EN END_ACTION END_CASE END_CONFIGURATION END_FOR END_FUNCTION
END_FUNCTION_BLOCK END_IF END_PROGRAM END_REPEAT END_RESOURCE END_STEP END_STRUCT END_TRANSITION END_TYPE
END_VAR END_WHILE ENO EQ ET EXIT EXP EXPT FALSE FIND FOR FROM FUNCTION FUNCTION_BLOCK F_EDGE F_TRIG GE GT IF IN
INITIAL_STEP INSERT INT INTERVAL JMP JMPC JMPCN L LD LDN LE LEFT LEN LIMIT LINT LN LOG LREAL LT LWORD MAX MID
MIN MOD MOVE MUL MULTIME MUX N NE NON_RETAIN NOT OF ON OR ORN P PRIORITY PROGRAM PT PV Q Q1 QD QU R R1 READ_ONLY
READ_WRITE REAL RELEASE REPEAT REPLACE RESOURCE RET RETAIN RETC RETCN RETURN RIGHT ROL ROR RS RTC R_EDGE R_TRIG
S S1 SD SEL SEMA SHL SHR SIN SINGLE SINT SL SQRT SR ST STEP STN STRING STRUCT SUB SUB_DATE_DATE SUB_DT_DT
SUB_DT_TIME SUB_TIME SUB_TOD_TIME SUB_TOD_TOD T TAN TASK THEN TIME TIME_OF_DAY TO TOD TOF TON TP TRANSITION TRUE
TRUNC TYPE UDINT UINT ULINT UNTIL USINT VAR VAR_ACCESS VAR_CONFIG VAR_EXTERNAL VAR_GLOBAL VAR_INPUT VAR_IN_OUT
VAR_OUTPUT VAR_TEMP WHILE WITH WORD WSTRING XOR XORN
";

/// What CODESYS has beyond that: object orientation, operators, long types, words reserved for later, and the function
/// blocks of its standard libraries.
const OF_CODESYS: &str = "
ABSTRACT ADR AND_THEN ANY_CHAR ANY_CHARS ANY_DURATION ANY_SIGNED ANY_UNSIGNED ATAN2 BIT BITADR BLINK CHAR
CHARCURVE CHAR_TO CLASS CONTINUE DERIVATIVE END_CLASS END_GET END_INTERFACE END_METHOD END_NAMESPACE
END_PROPERTY END_SET END_UNION EXTENDS EXTRACT FINAL FREQ_MEASURE GEN GET GOTO HYSTERESIS IMPLEMENTS INDEXOF INI
INTEGRAL INTERFACE INTERNAL LDATE LDATE_AND_TIME LDT LIMITALARM LIN_TRAFO LTIME LTIME_OF_DAY LTOD LTOF LTON LTP
METHOD NAMESPACE OR_ELSE OVERRIDE PACK PARAMS PD PERSISTENT PID POINTER PRIVATE PROPERTY PROTECTED PUBLIC PUTBIT
RAMP_INT RAMP_REAL REF REFERENCE REF_TO SET SIZEOF STATISTICS_INT STATISTICS_REAL SUPER TEST_AND_SET THIS
TO_CHAR TO_WCHAR TRUNC_INT UNION UNPACK USING UXINT VARIANCE VAR_GENERIC VAR_INST VAR_STAT WCHAR WCHAR_TO XINT
XSIZEOF XWORD
";

/// What TwinCAT has beyond CODESYS.
const OF_TWINCAT: &str = "
CLSID HRESULT IID OTCID PVOID T_AMSNETID T_MAXSTRING
";

/// What SCL has beyond the standard: keywords, system data types, and basic instructions.
const OF_SCL: &str = "
ASSIGNMENTATTEMPT ATH AUTHOR BEGIN BLKMOV BLOCK_DB BLOCK_FB BLOCK_FC BLOCK_SDB BLOCK_SFB BLOCK_SFC CALCULATE
CEIL CHAR CHARS_TO_STRG CODE_VERSION1 CONN_ANY CONST CONTINUE CONT_C CONT_S COUNTER COUNTOFELEMENTS DATA_BLOCK
DATE_AND_LTIME DB_ANY DECO DEMUX DESERIALIZE DTL ENCO ENDIS_PW END_CONST END_DATA_BLOCK END_LABEL
END_ORGANIZATION_BLOCK END_REGION ERROR_STRUCT EVENT_ANY FAMILY FILL FILL_BLK FLOOR FRAC GATHER GET_ERROR
GET_ERR_ID GOTO HTA HW_ANY HW_DEVICE HW_IO HW_SUBMODULE IEC_COUNTER IEC_LTIMER IEC_SCOUNTER IEC_TIMER
IEC_UCOUNTER ISARRAY IS_NULL JOIN KNOW_HOW_PROTECT LABEL LDT LOWER_BOUND LTIME LTIME_OF_DAY LTOD MAX_LEN
MOVE_BLK MOVE_BLK_VARIANT NAME NIL NORM_X NOT_NULL NREF OB_ANY OK ORGANIZATION_BLOCK PEEK PEEK_BOOL PIP POINTER
POKE POKE_BLK POKE_BOOL PORT PRESET_TIMER RD_LOC_T RD_SYS_T REF REF_TO REGION REMOTE RESET_TIMER RE_TRIGR ROUND
RTM RUNTIME S5TIME SCALE_X SCATTER SERIALIZE SPLIT SQR STP STRG_TO_CHARS STRG_VAL SWAP S_CD S_CONV S_CU S_CUD
S_MOVE S_ODT S_ODTS S_OFFDT S_OFFDTS S_PEXT S_PULSE TIMER TITLE TOF_TIME TONR TONR_TIME TON_TIME TP_TIME TYPEOF
TYPEOFELEMENTS T_ADD T_COMBINE T_CONV T_DIFF T_SUB UBLKMOV UFILL_BLK UMOVE_BLK UPPER_BOUND VAL_STRG VARIANT
VARIANTGET VARIANTPUT VERSION VOID WCHAR WR_LOC_T WR_SYS_T
";

/// Elementary types and what else stands on a side of a conversion function.
const STANDARD_TYPES: &str = "
BCD BOOL BYTE DATE DATE_AND_TIME DINT DT DWORD INT LINT LREAL LWORD REAL SINT STRING TIME TIME_OF_DAY TOD UDINT UINT
ULINT USINT WORD WSTRING
";

/// Types that came later.
const LONG_TYPES: &str = "
BIT CHAR DTL LDATE LDT LTIME LTOD S5TIME WCHAR XINT XWORD UXINT BCD16 BCD32
";

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lists_hold_words_once() {
        for words in [&EDITION2, &CODESYS, &TWINCAT, &SCL] {
            for list in words.lists {
                let list: Vec<&str> = list.split_ascii_whitespace().collect();
                assert!(list.is_sorted_by(|a, b| a < b), "sorted, each once");
                assert!(
                    list.iter().all(|word| word.chars().all(|c| matches!(c, 'A'..='Z' | '0'..='9' | '_')))
                );
            }
        }
    }

    /// IEC 61131-3:2003, tables 23 to 31 and 34 to 37.
    #[test]
    fn standard_functions_and_blocks_are_words() {
        let words: Vec<&str> = EDITION2.iter().collect();
        for name in "
            ABS SQRT LN LOG EXP SIN COS TAN ASIN ACOS ATAN ADD MUL SUB DIV MOD EXPT MOVE SHL SHR ROR ROL AND OR XOR NOT
            SEL MAX MIN LIMIT MUX GT GE EQ LE LT NE LEN LEFT RIGHT MID CONCAT INSERT DELETE REPLACE FIND
            ADD_TIME ADD_TOD_TIME ADD_DT_TIME SUB_TIME SUB_DATE_DATE SUB_TOD_TIME SUB_TOD_TOD SUB_DT_TIME SUB_DT_DT
            MULTIME DIVTIME CONCAT_DATE_TOD TRUNC SR RS R_TRIG F_TRIG CTU CTU_DINT CTU_LINT CTU_UDINT CTU_ULINT
            CTD CTD_DINT CTD_LINT CTD_UDINT CTD_ULINT CTUD CTUD_DINT CTUD_LINT CTUD_UDINT CTUD_ULINT TP TON TOF
        "
        .split_ascii_whitespace()
        {
            assert!(words.contains(&name), "{name}");
        }
    }

    #[track_caller]
    fn check(words: &Words, conversions: &[&str], others: &[&str]) {
        for name in conversions {
            assert!(words.is_conversion(name), "{name}");
        }
        for name in others {
            assert!(!words.is_conversion(name), "{name}");
        }
    }

    #[test]
    fn knows_conversions() {
        check(
            &EDITION2,
            &["INT_TO_REAL", "DATE_AND_TIME_TO_TOD", "BCD_TO_UINT", "REAL_TRUNC_INT", "WORD_BCD_TO_UINT"],
            &["ARM_TO_REAL", "INT_TO_ARM", "_TO_", "INT_TO_", "TO_INT", "INT_TO_LTIME"],
        );
        for words in [&CODESYS, &TWINCAT, &SCL] {
            check(words, &["INT_TO_REAL", "TO_INT", "INT_TO_LTIME"], &["TO_ARM", "TO_", "ARM_TO_INT"]);
        }
    }
}
