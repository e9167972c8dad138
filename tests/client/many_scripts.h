#pragma once
// Names and descriptions in many scripts, short and long, for tests of text.

#include <array>
#include <string_view>

namespace prosector::test {

struct Words {
  std::string_view script, name, description;
};

inline constexpr std::array<Words, 11> many_scripts = {{
    {"Latin", "liver", "The largest gland: it makes bile."},
    {"German", "großer Brustmuskel und Donaudampfschifffahrtsgesellschaft",
     "Er zieht den Oberarm vor die Brust, hilft bei erschöpfter Atmung die Rippen zu heben, und ist über den "
     "Schultergürtel hinweg mit Schlüsselbein, Brustbein und den Rippenknorpeln der zweiten bis sechsten "
     "Rippe "
     "verwachsen; die Faserbündel überkreuzen sich vor dem Ansatz."},
    {"Turkish", "göğüs kafesinin iç yüzündeki büyük kas",
     "Karaciğer, vücudun en büyük bezidir: şekeri glikojen olarak depolar, safra üretir ve bağırsaktan gelen "
     "kanı süzer. İğne ile alınan örnekler mikroskopta incelenir, çünkü hücrelerin dizilişi hastalığı "
     "gösterir."},
    {"Greek", "ήπαρ", "Ο μεγαλύτερος αδένας του σώματος: παράγει χολή και αποθηκεύει γλυκογόνο."},
    {"Cyrillic", "печень", "Самая крупная железа: вырабатывает желчь и очищает кровь."},
    {"Arabic", "الكبد", "أكبر غدة في الجسم: تفرز الصفراء وتخزن السكر وتنقي الدم."},
    {"Hebrew", "כבד", "הבלוטה הגדולה בגוף: מייצרת מרה ומסננת את הדם."},
    {"Devanagari", "यकृत", "शरीर की सबसे बड़ी ग्रन्थि: यह पित्त बनाती है।"},
    {"Chinese", "肝脏", "人体最大的腺体，能分泌胆汁，储存糖原，并过滤来自肠道的血液。"},
    {"Japanese", "肝臓", "体内でもっとも大きな腺で、胆汁をつくり、血液をきれいにする。"},
    {"one word", "WWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWW",
     "wwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwww"
     "ww"},
}};

}  // namespace prosector::test
