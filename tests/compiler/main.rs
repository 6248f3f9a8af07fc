//! Tests of documents, the compiler and the source tree itself, which need no GPU.

use chiaro_test_support as support;

mod automatic;
mod cases;
mod compile;
mod dark_lights;
mod document_format;
mod document_hcbtf;
mod document_history;
mod document_random;
mod document_read;
mod examples;
mod floors;
mod interp_lanes;
mod judges;
mod math;
mod messages;
mod scan;
mod techniques;
mod texts;
mod translations;
mod words;
