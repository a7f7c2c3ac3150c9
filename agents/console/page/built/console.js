var ul=class{#t;#e=new Map;#n=[];#i=!1;constructor(t){this.#t=t}shownIn(t,e){this.#n.push(e),this.#e.set(t,!1),new IntersectionObserver(n=>{this.#e.set(t,n[n.length-1].isIntersecting),this.#s()}).observe(t)}#s(){let t=[...this.#e.values()].includes(!0);if(t===this.#i)return;this.#i=t;let e=(n,s)=>this.#n.forEach(r=>r(n,s));this.#t.sampleActivity(t?e:null)}};var _t=i=>document.getElementById(i),E=(i,t,...e)=>Bp(document.createElement(i),t,e),Sn=(i,t,...e)=>Bp(document.createElementNS("http://www.w3.org/2000/svg",i),t,e);function Bp(i,t,e){for(let[n,s]of Object.entries(t))typeof s=="function"?i.addEventListener(n.slice(2),s):s===!0?i.setAttribute(n,""):s!==!1&&s!=null&&i.setAttribute(n,String(s));return i.append(...e.filter(n=>n!=null)),i}var Qi=i=>i.getContext("2d");function fl(i,t){let e=new Set(t);for(let n of[...i.children])e.has(n)||n.remove();t.forEach((n,s)=>{let r=i.children[s];r!==n&&i.insertBefore(n,r??null)})}var Sy=/[\u202a-\u202e\u2066-\u2069]/g,My=i=>i.replace(Sy,"\uFFFD"),Xt=(i,t=300)=>My(i.length>t?`${i.slice(0,t)} \u2026 (${i.length} characters)`:i),dl=(i,t)=>(Number(i.toFixed(t))+0).toFixed(t),We=i=>new Date(i/1e3).toLocaleTimeString("en-GB",{hour12:!1}),Te=i=>Xt(i.said??i.sentence??String(i),1600);function si(i){let t=!1;return()=>{t||(t=!0,requestAnimationFrame(()=>{t=!1,i()}))}}var pl=class{#t={};#e=[];set(t){this.#t=t;for(let e of this.#e)e()}onChange(t){this.#e.push(t)}words(t,e,n=1){let s=this.#t[t]??[];return e.map((r,o)=>{let[a,l]=s[o]??[`axis ${o+1}`,""];return[a,`${dl(r,n)} ${l}`.trim()]})}};var Jo=class{constructor(t){this.name=t}toString(){return this.name}},Ht=i=>new Jo(i),$=i=>i instanceof Jo?i.name:typeof i=="string"?i:"",kp=/\s*(?:;[^\n]*\n\s*)*(\(|\)|"(?:[^"\\]|\\.)*"|[^\s()";]+)/y,by={n:`
`,t:"	"};function wy(i){return i[0]==='"'?i.slice(1,-1).replace(/\\(.)/gs,(t,e)=>by[e]??e):/^[-+]?\d/.test(i)?Number(i):new Jo(i)}function ri(i){kp.lastIndex=0;let t=[[]];for(;;){let e=kp.exec(i);if(!e)break;if(e[1]==="(")t.push([]);else if(e[1]===")"){let n=t.pop();if(t.length===0)return[];t[t.length-1].push(n)}else t[t.length-1].push(wy(e[1]))}return t[0][0]??[]}var Ty=i=>`"${i.replace(/[\\"]/g,"\\$&").replace(/\n/g,"\\n").replace(/\t/g,"\\t").replace(/[\0-\x08\x0b-\x1f]/g," ")}"`;function te(i){return Array.isArray(i)?`(${i.map(te).join(" ")})`:typeof i=="string"?Ty(i):String(i)}var ml=class{#t;#e=null;#n=null;#i=null;constructor(t){this.#t=t}open(){this.#e&&this.#t.say(Ht("truth")),this.#n&&this.#t.say(Ht("activity")),this.#i&&this.#t.say(Ht("work"),this.#t.number())}hear(t){"truth"in t?this.#e?.(t.truth===null?null:ri(t.truth),t.said):"activity"in t?this.#n?.(t.activity,t.said):this.#i?.(t.work,t.changes)}layTruth(t){this.#e=t,this.#t.say(Ht(t?"truth":"truth-no-more"))}sampleActivity(t){this.#n=t,this.#t.say(Ht(t?"activity":"activity-no-more"))}earlierWork(t){this.#i=t,this.#t.say(Ht("work"),this.#t.number())}};var gl=class{#t;#e;#n;#i=0;stamp=0;constructor(t,e,n){this.#t=t,this.#e=e,this.#n=n}jog(t,e){this.#i=this.#t.number();let n=[Ht(t),Ht(e),this.stamp];return this.#s("jog",...n),this.#e.callAs(this.#i,null,"jog",...n)}holdOn(){this.#t.say(Ht("hold-on"),this.#i,this.stamp),this.#s("hold-on",this.stamp)}release(){this.#t.say(Ht("release"),this.#i),this.#s("release")}#s(t,...e){this.#n.say(te([Ht(t),this.#i,...e]))}};var Ey=1e3,zu=i=>{let t=new WebSocket(`${location.protocol.replace("http","ws")}//${location.host}${i}`);return t.binaryType="arraybuffer",t},_l=class{#t;#e=new Set;constructor(t){this.#t=t}open({path:t,lanes:e}){this.close();for(let n=0;n<e;++n)this.#n(t)}close(){let t=this.#e;this.#e=new Set;for(let e of t)e.close()}say(t){[...this.#e].find(({readyState:n})=>n===WebSocket.OPEN)?.send(t)}#n(t){let e=this.#e,n=zu(t);e.add(n),n.onmessage=async({data:s})=>{if(s==="(renew)")return this.#i(n);let r=performance.now();await this.#t(s),n.readyState===WebSocket.OPEN&&n.send(te([Ht("drawn"),Math.round(performance.now()-r)]))},n.onclose=()=>{let r=e.delete(n)?Ey:0;setTimeout(()=>e===this.#e&&this.#n(t),r)}}#i(t){this.#e.delete(t),t.close()}};var Ay=5e6;async function Vu(i){let t=new Uint8Array(i),e=t.indexOf(10),[,n,s,r,o,a]=ri(new TextDecoder().decode(t.subarray(0,e))),l=new Blob([t.subarray(e+1)],{type:"image/jpeg"}),c=await createImageBitmap(l).catch(()=>null);return[n,c&&{bitmap:c,number:s,captured:r,width:o,height:a}]}var xl=class{#t;#e=new Map;#n=new Map;lanes=new _l(t=>this.#i(t));constructor(t){this.#t=t}open(t){this.lanes.open(t);for(let e of this.#e.keys())this.#t.say(Ht("look"),Ht(e))}lost(){this.lanes.close()}add(t,e){return this.#e.set(t,e),this.#t.say(Ht("look"),Ht(t)),()=>{this.#e.delete(t),this.#t.say(Ht("look-away"),Ht(t))}}async#i(t){let[e,n]=await Vu(t);if(await new Promise(requestAnimationFrame),!n)return;let{captured:s}=n,r=this.#n.get($(e))??0;(s>=r||r-s>Ay)&&(this.#n.set($(e),s),this.#e.get($(e))?.(n)),n.bitmap.close()}};var yl=class{#t=new Map;#e;constructor(t){this.#e=t}change(t){t.resynchronised&&this.#t.clear();for(let e of t.removed)this.#t.delete(e.join());for(let e of t.added)this.#t.set(e.ids.join(),e);this.#e([...this.#t.values()],t)}};function ut(i){return i.read??=ri(i.facts[0].text),i.read}var Cy=4,vl=class{#t;#e=new Map;#n=new Map;#i=new Map;moment=null;constructor(t){this.#t=t}open(){for(let[t,e]of this.#e)this.#s(t,e)}lost(){for(let t of this.#i.values())t({error:this.#t.notConnected});this.#i.clear()}hear(t){let e=this.#e.get(t.watch);(t.past??null)===(e?.always?null:this.moment)&&e?.take(t),t.past&&this.#i.get(t.watch)?.(t)}refused(t,e){this.#i.get(t)?.(e),this.#e.get(t)?.take(e)}#s(t,e){e.once?this.#t.say(Ht("ask"),t,ri(e.query)):e.typed?this.#t.say(Ht("watch"),t,e.query):this.#t.say(Ht("follow"),t,ri(e.query))}#r(t,e,n,s,r=!1){let o=this.#t.number(),a=new yl(n),l={query:t,typed:e,always:r,take:c=>"error"in c?s(c.error):a.change(c)};return this.#e.set(o,l),this.#s(o,l),()=>{this.#e.delete(o),this.#t.say(Ht("unwatch"),o)}}follow(t,e,n=!1){let s=`${n} ${t}`,r=this.#n.get(s)??{listeners:[],told:null};if(r.listeners.push(e),r.told&&e(...r.told),this.#n.has(s))return;this.#n.set(s,r);let o=(...a)=>{r.told=a;for(let l of r.listeners)l(...a)};this.#r(t,!1,o,()=>{},n)}watch(t,e,n){return this.#r(t,!0,e,n)}ask(t){let e=this.#t.number();return new Promise(n=>{let s=o=>{this.#e.delete(e),n("error"in o?[]:o.added)},r={query:te(t),once:!0,take:s,always:!0};this.#e.set(e,r),this.#s(e,r)})}async askThen(t,e){let n=this.#t.number(),s=await this.#a(n,t,e);if(this.#i.delete(n),"error"in s)throw s.error;return s.added}async showMoment(t){this.moment=t;let e=[...this.#e].filter(([,n])=>!n.always);if(t!==null)return this.#o(e,t);for(let[n,s]of e)this.#t.say(Ht("unwatch"),n),this.#s(n,s);return null}async#o(t,e){let n=null,s=async()=>{for(let r=t.shift();r&&this.moment===e;r=t.shift()){let[o,a]=r,l=await this.#a(o,a.query,e);if(!("error"in l))continue;l.error.symbol==="undeclared-relation"?a.take({resynchronised:!0,cut:0,removed:[],added:[]}):n??=l.error}};return await Promise.all(Array.from({length:Cy},s)),n}#a(t,e,n){return new Promise(s=>{this.#i.set(t,s),this.#t.say(Ht("then"),t,ri(e),n)||s({error:this.#t.notConnected})})}};var Gu={symbol:"unreachable",sentence:"the console has gone; whether it was done is not known"},Sl=class{#t;#e=new Map;constructor(t){this.#t=t}lost(){for(let{reject:t}of this.#e.values())t(Gu);this.#e.clear()}hear(t,e){this.#e.get(t)?.take(e)}call(t,...e){return this.callAs(this.#t.number(),null,t,...e)}callWith(t,e,...n){return this.callAs(this.#t.number(),t,e,...n)}callAs(t,e,n,...s){return new Promise((r,o)=>{let a=l=>{e&&!("error"in l)?this.#e.set(t,{reject:()=>{},take:c=>this.#n(t,e,c)}):this.#e.delete(t),"error"in l?o(l.error):r(l.values)};this.#e.set(t,{reject:o,take:a}),!this.#t.say(Ht(n),t,...s)&&(this.#e.delete(t),o(this.#t.notConnected))})}#n(t,e,n){this.#e.delete(t),e(n)}};var Ml=class{#t;#e;#n=0;#i=!1;constructor(t){this.#t=t}begin(){this.end(),this.#i=!1,this.#n=performance.now(),this.#e=setInterval(()=>this.#s(),250)}end(){clearInterval(this.#e)}heard(){this.#n=performance.now(),this.#i&&this.#s()}#s(){let t=performance.now()-this.#n,e=this.#i;this.#i=t>2500,this.#i?this.#t("silent",`for ${Math.floor(t/1e3)} s`):e&&this.#t("live")}};var bl=class{#t;#e;#n;#i=null;open=()=>{};constructor(t,e,n){this.#t=t,this.#e=e,this.#n=n}async stop(t,e){try{return await this.#s(t)}catch(n){if(n!==Gu&&n!==this.#t.notConnected)throw n;return e(n),this.#i??=this.#r(t,e),this.#i}}#s(t){let e=this.#t.number();return this.#n.say(te([Ht("stop"),e,t])),this.#e.callAs(e,null,"stop",t)}async#r(t,e){return await new Promise(n=>this.open=()=>n(null)),this.#i=null,this.stop(t,e)}};var Hu="pizarra-loaded-for";function zp(i){_t("version-said").textContent=i,_t("version-note").hidden=!1,_t("version-read").onclick=()=>_t("version-note").hidden=!0}function Vp(i){let t=i!=="f86468c62d7e22fe",e=sessionStorage.getItem(Hu);return t?e===i?zp("This page is of another version than the console, and loading it anew did not help. STOP works; nothing else does."):(sessionStorage.setItem(Hu,i),location.reload()):(e===i&&zp("The console is of another version than before: this page was loaded anew."),sessionStorage.removeItem(Hu)),t}var Gp=500,Ry=4e3,Py=5,Hp=16384,wl=class{#t=null;#e=1;#n=Gp;#i=0;#s={say:(...t)=>this.#p(...t),number:()=>this.#e++,notConnected:{symbol:"unreachable",sentence:"the console is not connected"}};#r=new vl(this.#s);#o=new Sl(this.#s);#a=new xl(this.#s);#l=new gl(this.#s,this.#o,this.#a.lanes);#c=new bl(this.#s,this.#o,this.#a.lanes);#h=new ml(this.#s);#u=new Ml((t,e)=>this.onState(t,e));onState=()=>{};onHello=()=>{};onArm=()=>{};onPulse=()=>{};async open(){let t=location.hash.slice(1);t&&history.replaceState(null,"",location.pathname),await this.logIn(t)}async logIn(t){t&&await fetch("/session",{method:"POST",headers:{Authorization:`Bearer ${t}`}}).catch(()=>null),this.#f()}async logOut(){await fetch("/socket",{method:"DELETE"}).catch(()=>null),location.reload()}#f(){this.onState("connecting");let t=zu("/socket");t.onmessage=e=>typeof e.data=="string"?this.#m(JSON.parse(e.data)):this.#x(e.data),t.onclose=({reason:e})=>this.#d(e),this.#t=t}async#d(t){this.#t=null,this.#i=0,this.#l.stamp=0,this.#u.end();for(let n of[this.#a,this.#r,this.#o])n.lost();let e=await fetch("/socket").catch(()=>null);if(e?.status===403)return this.onState("refused",t);this.onState("lost",e?.status===503?(await e.text()).trim():t),setTimeout(()=>this.#f(),this.#n),this.#n=Math.min(this.#n*2,Ry)}#p(...t){if(this.#t?.readyState!==WebSocket.OPEN)return!1;let e=te(t);return new TextEncoder().encode(e).length>Hp?this.#g(Number(t[1])):this.#t.send(e),!0}#g(t){let e={symbol:"too-long",sentence:`${Hp>>10} kB are the most that can be said at once`};queueMicrotask(()=>this.#m({reply:t,error:e}))}#m(t){"error"in t&&(t.error.said=t.said),"hello"in t?this.#y(t.hello):"pulse"in t?this.#_(t):"reply"in t?(this.#o.hear(t.reply,t),"error"in t&&this.#r.refused(t.reply,t)):("watch"in t?this.#r.hear(t):"arm"in t?(t.past??null)===this.moment&&this.onArm(t):this.#h.hear(t),"error"in t||this.#v())}#y(t){if(this.#n=Gp,Vp(String(t.version)))return this.onState("outdated");this.onHello(t),this.onState("live"),this.#u.begin(),this.#a.open(t.images);for(let e of[this.#c,this.#r,this.#h])e.open()}#_(t){this.#l.stamp=t.pulse,this.#u.heard(),this.#p(Ht("stamp"),t.pulse),this.onPulse(t)}#v(){this.#i++>0||setTimeout(()=>{this.#p(Ht("heard"),this.#i),this.#i=0},Py)}get moment(){return this.#r.moment}showMoment=this.#r.showMoment.bind(this.#r);follow(t,e){this.#r.follow(t,e)}followAlways(t,e){this.#r.follow(t,e,!0)}watch=this.#r.watch.bind(this.#r);ask=this.#r.ask.bind(this.#r);askThen=this.#r.askThen.bind(this.#r);request(t,e){return this.#o.call("request",Ht(t),typeof e=="string"?ri(e):e)}goal(t,e){return this.#o.callWith(e,"goal",t)}stop(t,e){return this.#c.stop(t,e)}clearStops(){return this.#o.call("clear-stops")}hold(t,e){return this.#o.call(t,Ht(e))}async cells(){let[t]=await this.#o.call("cells");return JSON.parse(t)}async method(t){let[e]=await this.#o.call("method",t);return JSON.parse(e)}jog=this.#l.jog.bind(this.#l);holdOn=this.#l.holdOn.bind(this.#l);release=this.#l.release.bind(this.#l);layTruth=this.#h.layTruth.bind(this.#h);sampleActivity=this.#h.sampleActivity.bind(this.#h);earlierWork=this.#h.earlierWork.bind(this.#h);look=this.#a.add.bind(this.#a);async picture(t,e){let[n]=await this.#o.call("picture",Ht(t),e);return n}async#x(t){let[e,n]=await Vu(t);this.#o.hear(e,n?{values:[n]}:{error:{sentence:"what was kept is no picture"}})}};function Tl(i){let t=_t("confirm");return _t("confirm-text").textContent=i,t.showModal(),new Promise(e=>{let n=new AbortController,s=r=>{n.abort(),e(r)};t.addEventListener("submit",r=>s(r.submitter?.getAttribute("value")==="yes"),{signal:n.signal}),t.addEventListener("close",()=>t.open||s(!1),{signal:n.signal})})}function Bn(i,t){if(i===t)return"you";let e=/^(?:(.+)\/)?console-(\d+)-(\d+)$/,[,n,s,r]=i.match(e)??[];if(!r)return i;let o=s===t.match(e)?.[2]?"":` of console ${s}`;return`${n?`${n}, `:""}page ${r}${o}`}var _s=(i,t)=>i.replace(/(?<![\w./-])(?:[\w.-]+\/)?console-\d+-\d+(?![\w-])/g,e=>e===t?"this page":e.includes("/")?Bn(e,t):`console ${Bn(e,t)}`);var El=class{#t;#e;#n=[];#i=[];#s=[];#r="";#o=!1;#a=!1;#l=!1;change=null;me="";robot="robot";constructor(t,e){this.#t=t,this.#e=e,t.followAlways("(commander ?robot ?client)",n=>{this.#i=n.map(ut),this.#c(),this.changed()}),t.followAlways("(commander-wanted ?robot ?client)",n=>{this.#s=n.map(ut),this.changed()}),e.onChange(()=>this.changed())}get holder(){let t=this.#i.find(e=>$(e[1])===this.robot);return t?$(t[2]):""}get mine(){return this.#e.live&&this.me!==""&&this.holder===this.me}get whyNotTaken(){return this.#e.line||this.#e.right("command")}get why(){return this.whyNotTaken||this.#e.command("request")||(this.mine?"":"Take the arm in hand first")}get holderName(){return Bn(this.holder,this.me)}get askers(){return this.#s.filter(e=>$(e[1])===this.robot).map(e=>$(e[2])).filter(e=>e!==this.me).map(e=>Bn(e,this.me))}get asking(){return this.#s.some(t=>$(t[1])===this.robot&&$(t[2])===this.me)}#c(){let t=this.#r,e=this.#o,n=this.holder;if(this.#r=n,this.#o=n!==""&&n===this.me,t===n)return;let s={from:Bn(t,this.me),to:Bn(n,this.me)};this.#o?this.change=t?s:null:e&&!this.#a&&(this.change=s),this.#a=!1}onChange(t){this.#n.push(t),t(this.mine,this.holder)}changed(){let t=_t("arm-chip");t.hidden=this.holder==="",t.textContent=this.mine?"arm: in your hands":`arm: ${this.#e.live?this.holderName:"not known"}`,t.className=this.mine?"chip good":"chip warn";for(let e of this.#n)e(this.mine,this.holder);this.#h()}async#h(){if(!this.#e.live||!this.asking||this.#l||!(this.mine||this.holder===""))return;this.#l=!0;let t=this.mine?"ask-no-more":"command";await this.#t.hold(t,this.robot).catch(()=>{}),this.#l=!1,this.mine&&this.#h()}async toggle(){return this.mine?this.#u():this.holder===""?this.#t.hold("command",this.robot):await Tl(`${this.holderName} has the arm in hand. Take it over? Its motion ends.`)?this.#t.hold("take-over",this.robot):void 0}async#u(){this.#a=!0;try{await this.#t.hold("let-go",this.robot)}catch(t){throw this.#a=!1,t}}toggleWish(){return this.#t.hold(this.asking?"ask-no-more":"ask-for",this.robot)}};var Iy=["#want","#eyes","#drive","#head","#stopped","#hands-note","#confirm"];function Wp(){let i=t=>{let e=t.target instanceof Element&&t.target.closest("button:not(.stop)");t.detail<2||!e||!e.closest(Iy.join(", "))||(t.preventDefault(),t.stopPropagation())};window.addEventListener("click",i,{capture:!0})}function Li(i,t){let e=E("tbody",{}),n=s=>s instanceof HTMLTableCellElement?s:E("td",{},s instanceof Node?s:Xt(String(s)));return{panel:E("table",i,E("thead",{},E("tr",{},...t.map(s=>E("th",{},s)))),e),fill:s=>e.replaceChildren(...s.map(r=>E("tr",{},...r.map(n))))}}var Xp=10,Al=560,qp=220,Ko={width:104,height:26},$p=["QUERY","SEND","PUSH","EVENT","STREAM"],Yp=15,Ly=i=>i.length>Yp?`${i.slice(0,Yp-1)}\u2026`:i;function Dy({components:i,connections:t}){let e=new Map(i.map(({name:o},a)=>{let l=2*Math.PI*a/i.length-Math.PI/2;return[o,{x:Al/2+(qp+10)*Math.cos(l),y:Al/2+qp*Math.sin(l)}]})),n=({from:o,to:a,pattern:l,about:c})=>{let[h,u]=[e.get(o),e.get(a)];if(!h||!u)return null;let f=Math.max(Math.hypot(u.x-h.x,u.y-h.y),1),[d,g]=[(u.x-h.x)/f,(u.y-h.y)/f],y=4+5*$p.indexOf(l),p=Math.min(Ko.width/2/Math.max(Math.abs(d),.01),Ko.height/2/Math.max(Math.abs(g),.01))+4,m={x1:h.x+d*p+g*y,y1:h.y+g*p-d*y,x2:u.x-d*p+g*y,y2:u.y-g*p-d*y},v=Sn("title",{},`${o} ${l} ${a}: ${c.join(" ")}`);return Sn("line",{...m,class:`way ${l}`,"marker-end":`url(#end-${l})`},v)},s=$p.map(o=>Sn("marker",{id:`end-${o}`,markerWidth:7,markerHeight:7,refX:6,refY:3,orient:"auto"},Sn("path",{d:"M0,0 L6,3 L0,6 z",class:o}))),r=[...e].flatMap(([o,{x:a,y:l}])=>[Sn("rect",{x:a-Ko.width/2,y:l-Ko.height/2,...Ko,rx:5,class:"component"}),Sn("text",{x:a,y:l+4,"text-anchor":"middle"},Ly(o))]);return Sn("svg",{class:"graph",viewBox:`0 0 ${Al} ${Al}`,role:"img","aria-label":`${i.length} components and ${t.length} connections`},Sn("defs",{},...s),...t.map(n).filter(Boolean),...r)}var Ny=[["physical","a device"],["performance","a reaction time"],["abstraction","a function"]];function Uy({components:i,wrappers:t}){let e=new Map(t.map(n=>[n.component,n]));return i.map(n=>{let s=e.get(n.name),r=Ny.filter(([a])=>n[a]).map(([,a])=>a),o=(s?.abstraction??[]).map(a=>`${a.wrapped} ${a.operations}/${a.functions} = ${a.i_abstract.toFixed(3)}`);return[n.name,r.join(", ")||"none told",s?.offered??0,o.join("; ")||"\u2013",(s?.parts??[]).join(" ")]})}function Fy({connections:i}){return i.map(t=>[`${t.from} \u2192 ${t.to}`,t.pattern,t.count,t.p50_ms?`${t.p50_ms.toFixed(1)} / ${t.p99_ms.toFixed(1)}`:"\u2013",t.about.join(" "),t.remark||(t.recommended===t.pattern?"as the tables have it":t.recommended)])}function Cl(i,...t){return E("section",{"aria-label":i},E("h2",{},i),...t)}function Wu(i,t,e){let n=Li({id:i},t);return n.fill(e),E("div",{class:"scroll",tabindex:0,role:"group","aria-label":t[0]},n.panel)}function Oy(i){let{i_cpx:t,i_struct:e,i_cnx:n}=i,s=i.scales.map(({subscribers:r,p50_ms:o})=>`${r}: ${o.toFixed(2)} ms`).join(", ");return[Cl("Divide",E("p",{id:"indices"},`I_cpx ${t.toFixed(3)}, I_struct ${e.toFixed(3)}, I_cnx ${n.toFixed(3)}`),Dy(i),E("p",{class:"quiet"},"QUERY blue, SEND violet, PUSH green, EVENT orange, STREAM grey.")),Cl("Wrap",Wu("wrappers",["Component","Is one for","Operations","I_abstract","Parts of a wrapper"],Uy(i))),Cl("Connect",Wu("connections",["Connection","Pattern","Times","ms p50 / p99","About","The tables say"],Fy(i))),Cl("What is wrong",i.faults.length?Wu("faults",["Fault","Of","Why"],i.faults.map(r=>[r.symbol,r.subject,r.sentence])):E("p",{},"no fault was found"),s&&E("p",{class:"quiet"},`A fact reaches so many readers: ${s}.`))]}var By=(i,t)=>JSON.parse(JSON.stringify(i),(e,n)=>typeof n=="string"?_s(n,t):n);function Zp(i,t){let e=E("span",{class:"quiet",role:"status",id:"method-note"}),n=E("div",{id:"method"}),s=E("button",{type:"button",id:"method-look"},`Look for ${Xp} s`);return s.addEventListener("click",async()=>{s.disabled=!0,e.textContent="looking at who asks, answers, tells and watches \u2026";try{let r=By(await i.method(Xp),t());n.replaceChildren(...Oy(r).filter(Boolean)),e.textContent=`seen for ${r.seconds} s`}catch(r){e.textContent=Te(r)}s.disabled=!1}),E("details",{class:"goals"},E("summary",{},"The method: Divide, Wrap, Connect"),E("div",{class:"row"},s,e),n)}function Jp(i,t){let e=Li({id:"processes"},["Process","Host","Restarts","The last of it"]),n=E("span",{class:"quiet"},"0"),s=new Map;return i.follow("(process ?host ?name ?running ?restarts ?newest)",o=>{let a=o.map(ut).sort((l,c)=>$(l[2]).localeCompare($(c[2])));s.clear();for(let[,,l,,c]of a)s.set($(l),c);n.textContent=String(a.length),e.fill(a.map(([,l,c,h,u,f])=>[$(c),$(l),u,$(h)==="yes"?$(f):E("span",{class:"chip bad"},$(f))])),t()}),{panel:E("details",{class:"goals"},E("summary",{},"Processes and their restarts ",n),e.panel),restarts:s}}var Kp=50;function jp(i,t,e){let n=E("span",{class:"quiet",id:"refusal-count"},"0"),s=Li({id:"refusals"},["Client","Refused","Times","The newest"]),r=Li({id:"clients"},["Client","Requests/s"]);i.follow("(board-refusal ?client ?symbol ?count ?sentence)",a=>{let l=a.map(ut).sort((c,h)=>h[3]-c[3]);n.textContent=String(l.length),s.fill(l.slice(0,Kp).map(([,c,h,u,f])=>[_s($(c),e()),$(h),u,$(f)]))});let o=E("details",{class:"goals"},E("summary",{},"Refused by the board ",n),s.panel,r.panel);return t.shownIn(o,a=>r.fill((a?.clients??[]).slice(0,Kp).map(l=>[_s(l.name,e())||"(no hello)",l.requests_per_second]))),o}var ky={wired:"","stands-in":"stands in",absent:"is away"},zy=64;function Qp(i){let t=E("tbody",{}),e=["Client","Role","Is played by",""].map(s=>E("th",{},s));i.follow("(holder ?client ?role ?server ?state)",s=>{let r=s.map(o=>ut(o).slice(1).map($)).sort();t.replaceChildren(...r.slice(0,zy).map(([o,a,l,c])=>E("tr",{class:c==="wired"?"":"warn"},...[o,a,l,ky[c]??c].map(h=>E("td",{},Xt(h,64))))))});let n=E("table",{id:"served"},E("thead",{},E("tr",{},...e)),t);return E("details",{class:"goals",open:!0},E("summary",{},"Who serves whom"),n)}function Vy(i,t){let e=i?`${i.told_per_second.toFixed(1)} told/s, ${i.waiting} waiting, ${i.queued} queued`:"",n=t===void 0?"":`${t} restart${t===1?"":"s"}`;return[e,n].filter(Boolean).join(", ")}function tm(i,t,e){let n=E("div",{class:"timeline"}),s=new Map,r=new Map,o=[],a=new Map,l=u=>{if(r.has(u))return r.get(u);let f=E("span",{class:"quiet"}),d=E("span",{class:"quiet load"}),g=E("pre",{}),y=E("strong",{title:u}),p=E("details",{"data-agent":u},E("summary",{},y,f,d),g);return r.set(u,{made:p,label:y,who:f,does:d,offers:g}),r.get(u)},c=()=>{let u=o.slice(0,64).map(f=>{let d=$(f[1]),{label:g,who:y,does:p,offers:m}=l(d);g.textContent=Xt(_s(d,e()),64),y.textContent=`${$(f[2])} on ${Xt($(f[3]),64)}`,p.textContent=Vy(a.get(d),h.restarts.get(d));let v=s.get(d);return m.textContent=v?Xt(v.map(te).join(`
`),6e3):"it told no contract",d});for(let f of r.keys())u.includes(f)||r.delete(f);n.replaceChildren(...u.map(f=>r.get(f).made))},h=Jp(i,()=>c());_t("agents").append(n,h.panel,jp(i,t,e),Qp(i),Zp(i,e)),t.shownIn(n,u=>{a=new Map((u?.agents??[]).map(f=>[f.name,f])),c()}),i.follow("(agent ?name ?kind ?host)",u=>{o=u.map(ut).sort((f,d)=>$(f[1]).localeCompare($(d[1]))),c()}),i.follow("(contract ?name ?form)",u=>{s.clear();for(let[,f,d]of u.map(ut))s.set($(f),d.filter(Array.isArray));c()})}var Gy=5e3,nm=["Cell","Agents","Goal","Arms","Stopped by","Last word"],em=i=>i&&E("span",{class:"chip bad"},i);function Hy({path:i,console:t,leads:e}){let n=i||"this one",s=t.startsWith("https://");return E("td",{},s?E("a",{href:t,target:"_blank",rel:"noopener noreferrer"},n):n,e&&E("small",{class:"quiet"},`${e} leads`))}function Wy(i){let t=Hy(i);return i.fault?[t,E("td",{colspan:nm.length-1},em(i.fault))]:[t,i.agents,i.goal,i.arms,em(i.stops),i.said]}function Xy(i,t){let e=document.activeElement,n=e instanceof HTMLAnchorElement&&i.panel.contains(e)&&e.href;i.fill(t),n&&[...i.panel.querySelectorAll("a")].find(s=>s.href===n)?.focus()}function im(i){let t=Li({id:"cells-table"},nm),e=E("p",{class:"quiet",role:"status"},"looking \u2026"),n=_t("cells");n.append(t.panel,e);let s=!1,r=!1,o=0,a=async()=>{if(clearTimeout(o),!(r||!s)){r=!0;try{let l=await i.cells();Xy(t,l.cells.map(Wy)),e.textContent=l.more?`More than these ${l.cells.length} are named: ./pizarra cells lists all`:""}catch(l){e.textContent=Te(l)}r=!1,o=setTimeout(a,Gy)}};new IntersectionObserver(l=>{s=l[l.length-1].isIntersecting,a()}).observe(n),i.follow("(context-board ?name ?address)",l=>{l.length>0&&(_t("tab-cells").hidden=!1)})}var qy=/^(Arrow\w+|Page\w+|Home|End)$/;function sm(i,t,e){let n=E("output",{},""),s=E("input",{type:"range","aria-label":i,...e}),r=()=>{n.textContent=`${s.value} ${t}`,s.setAttribute("aria-valuetext",n.textContent)};return s.addEventListener("input",r),r(),{row:E("label",{class:"slide"},E("span",{},i),s,n),input:s,show:r}}function rm(i,{letGo:t,drop:e}){let n="",s=!1,r=l=>{n=l,s=!1},o=()=>{n="",e()};i.addEventListener("pointerdown",()=>r("pointer")),i.addEventListener("keydown",({key:l})=>{qy.test(l)&&r("key"),l==="Escape"&&(s=n==="pointer",o())});let a=()=>{n="",s?e():t(),s=!1};i.addEventListener("change",()=>n!=="key"&&a()),i.addEventListener("keyup",()=>n==="key"&&a()),i.addEventListener("pointerup",()=>n="");for(let l of["pointercancel","blur"])i.addEventListener(l,o);return()=>n!==""}function Rl({label:i,unit:t,most:e,form:n},s){let{row:r,input:o,show:a}=sm(i,t,{min:-e,max:e,step:1,value:0}),l=()=>{let h=Number(o.value);return o.value="0",a(),h};return rm(o,{letGo:()=>{let h=l();h!==0&&s(n(h))},drop:l}),{row:r,input:o}}function jo({label:i,unit:t,least:e,most:n,value:s,form:r},o){let{row:a,input:l,show:c}=sm(i,t,{min:e,max:n,step:1,value:s}),h=s,u=()=>{l.value=String(h),c()},f=rm(l,{letGo:()=>o(r(Number(l.value))),drop:u});return{row:a,input:l,put:g=>{h=g,f()||u()}}}var Qo=(i,t,e)=>n=>`(${i} ${n>0?t:e} ${Math.abs(n)})`,$y=[{label:"Retract / extend",unit:"mm",most:100,form:i=>i>0?`(extend keep-height ${i})`:`(retract ${-i})`},{label:"Turn left / right",unit:"\xB0",most:45,form:Qo("turn","right","left")},{label:"Move left / right",unit:"mm",most:100,form:Qo("move-h","right","left")},{label:"Move down / up",unit:"mm",most:100,form:Qo("move-v","up","down")},{label:"Tool down / up",unit:"\xB0",most:45,form:Qo("turn-ef","up","down")},{label:"Wrist left / right",unit:"\xB0",most:90,form:Qo("turn-wrist","right","left")}],Yy=i=>({label:"Gripper close / open",unit:"mm",most:60,form:t=>`(gripper ${Math.max(0,Math.round(i()+t))})`}),om={label:"Gripper opening",unit:"mm",least:0,most:100,value:80,form:i=>`(gripper ${i})`},Zy={label:"Speed",unit:"%",least:1,most:100,value:50,form:i=>`(speed ${i})`};function am(i,t,e){let n=om.value,s=[...$y,Yy(()=>n)].map(l=>Rl(l,e)),r=jo(om,e),o=jo(Zy,e),a=(l,c)=>i.follow(l,h=>{let u=h.map(ut).find(f=>$(f[1])===t.robot);u&&c(u[2])});return a("(robot-speed ?robot ?percent)",o.put),a("(gripper ?robot ?opening)",l=>{n=l,r.put(Math.round(l))}),{rows:[...s,r,o].map(l=>l.row),moving:[...s,r].map(l=>l.input),speed:o.input}}var Jy=60,Gr=class{#t;#e;#n;list;constructor(t,e,n,s){this.#t=t,this.#e=e,this.#n=n,this.list=E("ol",{class:"log","aria-label":s}),t.followAlways("(request ?id ?agent ?operation)",(r,o)=>this.#s(o.added))}#i(t,e){let n=E("span",{}),s=E("li",{},E("time",{},We(Date.now()*1e3)),E("span",{class:"quiet"},`${Xt(t,40)} `),E("code",{},Xt(e,200)),n);for(this.list.prepend(s);this.list.children.length>Jy;)this.list.lastChild?.remove();return{item:s,answer:n}}#s(t){for(let e of t){let{teller:n}=e.facts[0],[,,s,r]=ut(e);$(s)===this.#e()&&n!==this.#n()&&this.#i(Bn(n,this.#n()),te(r))}}async follow(t,e){let{item:n,answer:s}=this.#i("you",t);s.textContent=" \u2026";try{s.textContent=` ${Xt((await e).join(" ")||"ok",200)}`}catch(r){s.textContent=` ${Te(r)}`,n.className="bad"}}send(t){return this.follow(t,this.#t.request(this.#e(),ri(t)))}};var Ky=50,jy=[["left","\u25C0","Left"],["up","\u25B2","Up"],["out","\u21E7","Out"],["turn-left","\u27F2","Turn left"],["tool-up","\u2912","Tool up"],["wrist-left","\u21BA","Wrist left"],["right","\u25B6","Right"],["down","\u25BC","Down"],["in","\u21E9","In"],["turn-right","\u27F3","Turn right"],["tool-down","\u2913","Tool down"],["wrist-right","\u21BB","Wrist right"]],Xu=class{#t;#e;#n;#i;#s=null;#r=null;constructor(t,e,n){this.#t=t,this.#e=e,this.#n=n,e.onChange(()=>e.why&&this.end()),window.addEventListener("blur",()=>this.end()),window.addEventListener("pagehide",()=>this.end()),document.addEventListener("visibilitychange",()=>{document.hidden&&this.end()})}begin(t,e){if(this.#s||this.#e.why)return;let n={button:e};this.#s=n,e.classList.add("held");let s=()=>this.#s===n&&this.#o(t,n);this.#r?this.#r.then(s):s()}#o(t,e){let n=this.#t.jog(this.#e.robot,t);this.#n.follow(`(jog ${t})`,n),this.#i=setInterval(()=>this.#t.holdOn(),Ky);let s=()=>{this.#r=null,this.#s===e&&this.end()};this.#r=n.then(s,s)}end(){this.#s&&(clearInterval(this.#i),this.#t.release(),this.#s.button.classList.remove("held"),this.#s=null)}};function Qy(i,[t,e,n]){let s=E("button",{type:"button",class:"jog","data-jog":t,"aria-label":`Jog: ${n}`,title:n},E("span",{"aria-hidden":"true"},e),E("small",{"aria-hidden":"true"},n));s.addEventListener("pointerdown",r=>{r.button===0&&(s.setPointerCapture(r.pointerId),i.begin(t,s))});for(let r of["pointerup","pointercancel","lostpointercapture","blur"])s.addEventListener(r,()=>i.end());return s.addEventListener("contextmenu",r=>r.preventDefault()),s.addEventListener("keydown",r=>{r.key==="Escape"&&i.end(),!(r.key!==" "&&r.key!=="Enter")&&(r.preventDefault(),r.repeat||i.begin(t,s))}),s.addEventListener("keyup",r=>{(r.key===" "||r.key==="Enter")&&i.end()}),s}function lm(i,t,e){let n=new Xu(i,t,e),s=jy.map(a=>Qy(n,a)),r=E("p",{class:"quiet",id:"jog-note"},"");return i.onPulse=({deadline:a,rtt:l})=>{let c=l<0?"not measured yet":`${l.toFixed(0)} ms there and back`;r.textContent=`Hold to move. Line: ${c}; silence of ${a.toFixed(0)} ms stops the arm, within 10 mm.`},{parts:[E("div",{class:"jogs",role:"group","aria-label":"Jog: hold to move"},...s),r],buttons:s}}function cm(i,t,e){let n=E("datalist",{id:"variables"}),s=E("input",{id:"variable",list:"variables",maxlength:32,size:12,spellcheck:"false",placeholder:"p1","aria-label":"Name of a place",pattern:"[a-z][a-z0-9\\-]*",title:"a letter, then letters, digits and hyphens"}),r=l=>()=>s.value&&s.reportValidity()&&e.send(`(${l} ${s.value})`),o=E("button",{type:"button",onclick:r("learn")},"Save"),a=E("button",{type:"button",onclick:r("goto")},"Go to");return i.follow("(robot-variable ?robot ?name ?joints)",l=>{let c=l.map(ut).filter(h=>$(h[1])===t.robot);n.replaceChildren(...c.map(h=>E("option",{value:$(h[2])})))}),{parts:[s,n,o,a],name:s,save:o,go:a}}var Mn=class{note;#t=new Map;constructor(t){this.note=E("p",{class:"reasons",id:t,hidden:!0})}set(t,e,n){for(let r of e)r.dataset.title??=r.title,r.disabled=n!=="",r.title=n||r.dataset.title,n?r.setAttribute("aria-describedby",this.note.id):r.removeAttribute("aria-describedby");let s=e.length>0?n:"";(this.#t.get(t)??"")!==s&&(this.#t.set(t,s),this.#e())}#e(){let t=new Map;for(let[e,n]of this.#t)n&&t.set(n,[...t.get(n)??[],e]);this.note.replaceChildren(...[...t].map(([e,n])=>E("span",{},E("strong",{},n.join(", ")),`: ${e}. `))),this.note.hidden=t.size===0}};function hm(i,t,e){let n=E("span",{id:"service-light",class:"chip",role:"status"}),s=new Set,r=new Map,o=()=>s.has(t.robot)?r.has(t.robot)?`${Bn(r.get(t.robot)??"",t.me)} released control: get it first`:"":"No robot is present",a=()=>{n.textContent=o()||"In service",n.className=`chip ${o()?"bad":"good"}`,e()};return i.followAlways("(agent ?name robot ?host)",l=>{s=new Set(l.map(c=>$(ut(c)[1]))),a()}),i.followAlways("(robot-released ?robot ?client)",l=>{r=new Map(l.map(c=>[$(ut(c)[1]),$(ut(c)[2])])),a()}),t.onChange(a),{light:n,why:o}}function um(i,t){let e=new Mn("why-take"),n=E("span",{class:"quiet"}),s=a=>()=>a().catch(l=>n.textContent=Te(l)),r=E("button",{type:"button",id:"take-arm",class:"strong",onclick:s(()=>i.toggle())}),o=E("button",{type:"button",id:"ask-for-arm",onclick:s(()=>i.toggleWish())});return i.onChange((a,l)=>{e.set("The arm in hand",[r],i.whyNotTaken);let c=l!==""&&!a;e.set("To ask for it",c?[o]:[],t.line||t.right("ask-for")),o.hidden=!c,o.textContent=i.asking?"Ask no more":"Ask for it",r.textContent=a?"Let the arm go":l?`Take over from ${i.holderName}`:"Take the arm in hand";let h=i.asking?`${i.holderName} is asked for it.`:"";n.textContent=a?"Only you move the arm now.":l?h:"Anybody may move the arm: a goal, a prompt."}),[E("div",{class:"row"},r,o,n),e.note]}function tv(i,t,e){let n=E("output",{class:"axes","aria-label":"Axis positions"},"no arm has told its joints yet");return i.follow("(arm-joints ?robot ?joints)",s=>{let r=s.map(ut).find(o=>$(o[1])===t.robot);r&&(n.textContent=e.words(t.robot,r[2]).map(o=>o.join(" ").replaceAll(" ","\xA0")).join("   "))}),n}function ev(i){let t=E("input",{id:"action",maxlength:4e3,spellcheck:"false",placeholder:"(move 350 0 300)   or   CIRCLE p1, p2, p3","aria-label":"Action"}),e=E("button",{type:"submit"},"Do action"),n=E("form",{class:"row"},t,e);return n.addEventListener("submit",s=>{s.preventDefault(),t.value&&i.send(te([Ht("do-action"),t.value]))}),{form:n,controls:[t,e]}}function nv(i,t,e){let n=g=>e.send(g),s=(g,y)=>E("button",{type:"button",onclick:()=>n(y)},g),r=[s("Home","(home)"),s("Ready","(ready)")],o=[s("Get control","(get-control)"),s("Release control","(release-control)")],a=[s("Monitor","(monitor)"),s("Finish: report","(finish report)"),s("Finish: stop","(finish stop)"),s("Status","(get-status)")],l=lm(i,t,e),c=am(i,t,n),h=cm(i,t,e),u=ev(e),f=[...r,...c.moving,h.go,...u.controls],d=[...o,c.speed,h.name,h.save];return{poses:r,service:o,questions:a,jog:l,slides:c,places:h,action:u,moving:f,still:d}}function fm({connection:i,permission:t,hands:e,axes:n}){let s=new Gr(i,()=>e.robot,()=>e.me,"Commands that the arm received, newest first"),{poses:r,service:o,questions:a,jog:l,slides:c,places:h,action:u,moving:f,still:d}=nv(i,e,s),g=new Mn("why-drive"),y=()=>{},{light:p,why:m}=hm(i,e,()=>y());y=()=>{g.set("Jogs",l.buttons,t.right("jog")||e.why||m()),g.set("Slides, poses and actions",f,e.why||m()),g.set("Speed, places and control",d,e.why),g.set("Questions and Finish",a,t.line||t.right("request"))},_t("drive").append(...um(e,t),g.note,E("div",{class:"row"},p,...o,...r),E("div",{class:"row"},...a),E("div",{class:"driving"},E("div",{},...l.parts),E("div",{class:"slides"},...c.rows)),E("div",{class:"row"},...h.parts,tv(i,e,n)),u.form,E("h2",{},"Commands received"),s.list),y()}var Pl=class{#t;#e=new Map;#n=[];constructor(t){this.#t=t,t.followAlways("(holder console ?role ?server ?state)",e=>{let n=e.map(ut).filter(([,,,,s])=>$(s)!=="absent");this.#e=new Map(n.map(([,,s,r])=>[$(s),$(r)]));for(let s of this.#n)s()})}server(t){return this.#e.get(t)??""}follow(t,e,n){let s=[],r=()=>{let o=this.server(t);n(o===""?s:s.filter(a=>$(a[1])===o))};this.#t.follow(e,o=>{s=o.map(ut),r()}),this.onChange(r)}onChange(t){this.#n.push(t)}};var qu=i=>i[2]??"no reason was told",Il=class{#t;eyes="vision";panel=E("pre",{class:"answer",id:"eyes-answer",role:"status",hidden:!0});constructor(t){this.#t=t}values(...t){return this.#t.request(this.eyes,t)}button(t,...e){return E("button",{type:"button",onclick:()=>this.#e(e)},t)}async#e(t){this.panel.hidden=!1,this.panel.textContent="\u2026";try{let e=await this.values(...t),n=/ FAIL\)/.test(e[0]??"")?[e[0],qu(e)]:e;this.panel.textContent=Xt(n.join(`
`)||"ok",2e3)}catch(e){this.panel.textContent=Te(e)}}};var Vs="end-effector",dm="unnamed-",pm=i=>dm+i,Dl=i=>!i.startsWith(dm),iv=["Area","Perimeter","NF","M0","M1","M2"],Ll=class{#t=[];#e=new Map;#n=[];#i=[];constructor(t){let e=(n,s)=>t.follow("eyes",n,r=>{s(r),this.#s()});e("(learned ?eyes ?name ?num ?area ?perimeter ?nf ?m0 ?m1 ?m2)",n=>this.#t=n),e("(learned-template ?eyes ?name ?num ?tone ? ? ? ? ? ? ?picture)",n=>{this.#e=new Map(n.map(s=>[`${s[1]} ${s[2]} ${s[3]}`,s]))}),e("(look-alike ?eyes ?name ?other ?error ?sentence)",n=>this.#n=n)}onChange(t){this.#i.push(t)}#s(){for(let t of this.#i)t()}names(){let t=[...new Set(this.#t.map(e=>$(e[2])))].sort();return t.includes(Vs)?[Vs,...t.filter(e=>e!==Vs)]:t}samples(t){return this.#t.filter(e=>$(e[2])===t).map(e=>this.#r(e))}newest(t){return this.samples(t).toSorted((e,n)=>n.num-e.num)[0]}alike(t){return this.#n.filter(e=>[$(e[2]),$(e[3])].includes(t)).map(e=>$(e[5]))}#r(t){let e=this.#e.get(`${t[1]} ${t[2]} ${t[3]}`),n=t.slice(4).map((s,r)=>[iv[r],s.toFixed(Number.isInteger(s)?0:3)]);return{eyes:$(t[1]),num:t[3],parameters:n,picture:e?$(e.at(-1)):"",tone:e?$(e[4]):"dark"}}};var Hr=32;function Nl(i,t,e){let n=E("canvas",{class:"template",width:Hr,height:Hr,role:"img","aria-label":e});if(!/^[0-9a-f]{1024}$/.test(i))return n;let s=Qi(n),r=s.createImageData(Hr,Hr);for(let o=0;o<Hr*Hr;++o){let a=parseInt(i[o],16)/15,l=Math.round(255*(t==="light"?a:1-a));r.data.set([l,l,l,255],4*o)}return s.putImageData(r,0,0),n}var sv=64,rv=([,,,i,,t])=>$(i)==="lost"?"lost":`${$(i)}, ${(t*100).toFixed(0)} %`;function ov(i,t){let e=t.map(n=>Nl(n.picture,n.tone,`Sample ${n.num} of ${Xt(i,64)}`));return E("span",{class:"templates"},...e)}function av(i,t,e,n){let s=[...new Set(t.map(o=>o.eyes))].join(", "),r=` ${t.length} sample${t.length>1?"s":""} by ${Xt(s,64)}; `;return E("span",{},E("strong",{},Dl(i)?Xt(i,64):"not named yet"),E("span",{class:"quiet"},r,n),...e.map(o=>E("small",{class:"warn"},Xt(o,160))))}var Ul=class{#t;#e;#n;#i=new Map;#s=new Map;panel=E("ul",{class:"objects","aria-label":"Learned objects"});constructor(t,e,n){this.#t=t,this.#e=e,this.#n=n}draw(){let t=this.#t.names().slice(0,sv);for(let e of this.#i.keys())t.includes(e)||this.#i.delete(e);fl(this.panel,t.map(e=>this.#o(e).item)),this.#r()}showTracked(t){this.#s=new Map(t.map(e=>[$(e[2]),e])),this.#r()}gate(t,e){let n=[...this.#i.values()].map(s=>s.buttons);t.set("Add sample",n.map(({more:s})=>s),e.train),t.set("Find",n.map(({find:s})=>s),e.find),t.set("Track",n.map(({track:s})=>s),e.track),t.set("Forget",n.map(({forget:s})=>s),e.forget)}#r(){for(let[t,{state:e}]of this.#i){let n=this.#s.get(t);e.textContent=n?rv(n):"not tracked"}}#o(t){let e=this.#t.samples(t),n=this.#t.alike(t),s=JSON.stringify([e,n]),r=this.#i.get(t);if(r?.of===s)return r;let o=E("span",{}),a=this.#a(t),{find:l,track:c,more:h,forget:u}=a,f=E("li",{},ov(t,e),av(t,e,n,o),E("span",{class:"buttons"},l,c,h,u)),d={of:s,item:f,state:o,buttons:a};return this.#i.set(t,d),d}#a(t){return{find:this.#e.button("Find",Ht("find"),t),track:this.#e.button("Track",Ht("track"),t),more:E("button",{type:"button",onclick:()=>this.#n(t)},"Add sample"),forget:this.#e.button("Forget",Ht("forget"),t)}}};var Wr=3,lv=8192,Fl={missing:"#4b3a17",grid:"#2a3b47",taken:"#7fd18b",now:"#f2a33a"};function mm(i,t,e,n){let s=Qi(i);s.strokeStyle=e,s.lineWidth=n,s.beginPath();for(let r=0;r+1<t.length;r+=2)s.lineTo(t[r],t[r+1]);s.closePath(),s.stroke()}function cv(i,t){let e=Qi(i),[n,s]=[i.width/Wr,i.height/Wr];e.clearRect(0,0,i.width,i.height),e.fillStyle=Fl.missing;for(let[,r,o]of t)e.fillRect(r*n,o*s,n,s);e.strokeStyle=Fl.grid,e.lineWidth=1;for(let r=0;r<Wr*Wr;++r)e.strokeRect(r%Wr*n,Math.floor(r/Wr)*s,n,s)}var ta=class{#t;#e=E("canvas",{role:"img"});#n=E("small",{});panel=E("div",{class:"boards"},this.#e,this.#n);constructor(t){this.#t=t}show({width:t,height:e,taken:n,newest:s,lacks:r,isPair:o}){let a=this.#t,l=[t,e].every(c=>c>0&&c<=lv);if(this.panel.hidden=!l||!n.some(c=>a in c),!this.panel.hidden){this.#n.textContent=`Boards in the ${o?["left ","right "][a]:""}image`,this.#e.setAttribute("aria-label",this.#n.textContent),Object.assign(this.#e,{width:t,height:e}),cv(this.#e,r.map(([,,c])=>c).filter(([c])=>c===a));for(let c of n)a in c&&mm(this.#e,c[a],Fl.taken,2);a in s&&mm(this.#e,s[a],Fl.now,4)}}};var hv={looking:"looking for boards",fitting:"fitting",done:"done",failed:"failed"},uv={done:"good",failed:"bad"},fv=64,dv=32;function pv(i,t){let e={now:void 0,taken:[],newest:[],sees:"",lacks:[]},n=(s,r)=>i.follow(s,o=>{r(o.map(ut)),t(e)});n("(calibration ?state ?sentence ?width ?height ?boards ?wanted)",([s])=>e.now=s),n("(calibration-board ?number ?outlines)",s=>{e.taken=s.slice(0,fv).map(r=>r[2])}),n("(calibration-sees ?outlines ?sentence)",([s])=>{e.newest=s?.[1]??[],e.sees=s?`the newest image: ${Xt($(s[2]))}`:""}),n("(calibration-lacks ?sentence ?part)",s=>e.lacks=s.slice(0,dv))}function gm(i){let t=E("span",{class:"chip",id:"calibration-state",role:"status"}),e=E("span",{id:"calibration-count"}),n=E("p",{id:"calibration-sentence",hidden:!0}),s=E("span",{class:"quiet",id:"calibration-sees"}),r=E("ul",{id:"calibration-lacks","aria-label":"Still missing"}),o=[new ta(0),new ta(1)],a=E("section",{id:"calibration","aria-label":"Calibration",hidden:!0},E("div",{class:"row"},E("h2",{},"Calibration"),t,e,s),n,E("div",{class:"calibrating"},...o.map(l=>l.panel),r));return pv(i,l=>{let{now:c,taken:h,lacks:u}=l;if(a.hidden=c===void 0,c===void 0)return;let[,f,d,g,y,p,m]=c,v=$(f);t.textContent=hv[v]??v,t.className=`chip ${uv[v]??"busy"}`,e.textContent=`${p} of ${m} boards`,s.textContent=l.sees,n.textContent=Xt($(d),1e3),n.hidden=n.textContent==="";let C=u.length?u.map(([,P])=>Xt($(P))):["nothing more"];r.replaceChildren(...C.map(P=>E("li",{},P)));let b=h.some(P=>1 in P);for(let P of o)P.show({width:g,height:y,taken:h,newest:l.newest,lacks:u,isPair:b})}),a}var mv=[Vs,"circle","triangle","square","cross"],$u={maxlength:64,spellcheck:"false",pattern:"[A-Za-z][A-Za-z0-9\\-]*",title:"a letter, then letters, digits and hyphens"};function gv({name:i,isNew:t},e){let s=[["Name",t?"to be named":i],...e.parameters,["Num",String(e.num)]].flatMap(([r,o])=>[E("dt",{},r),E("dd",{},o)]);return E("dl",{class:"parameters"},...s)}var Ol=class{#t;#e;#n=null;#i=E("div",{class:"learned-sample"});panel=E("div",{class:"learned-window",id:"learned-window",role:"group",hidden:!0});constructor(t,e){this.#t=t,this.#e=e}open(t){this.#n=t;let e=E("input",{id:"new-name",required:!0,value:t.isNew?"":t.name,...$u});this.panel.replaceChildren(this.#i,this.#s(e,t.isNew)),this.showSample(),this.panel.hidden=!1,e.focus()}hide(){this.#n=null,this.panel.hidden=!0}rename(t){this.#n={name:t,isNew:!1,before:0}}showSample(){let t=this.#n,e=t&&this.#t.newest(t.name);if(!t||!e||e.num<=t.before)return this.#i.replaceChildren();this.#i.replaceChildren(Nl(e.picture,e.tone,`What was learned as ${t.name}`),gv(t,e),...this.#t.alike(t.name).map(n=>E("p",{class:"warn"},Xt(n))))}#s(t,e){let n=this.#t.names(),s=a=>E("button",{type:"button",class:"small",onclick:()=>t.value=a},a),r=e?mv.filter(a=>!n.includes(a)).map(s):[],o=E("form",{class:"row"},E("label",{for:t.id},"Name it"),t,...r,E("button",{type:"submit",class:"strong"},"Accept"),E("button",{type:"button",id:"reject",onclick:()=>this.#e.reject()},"Reject"));return o.addEventListener("submit",a=>{a.preventDefault(),this.#e.accept(t.value)}),o}};var _v=i=>/^\(LEARN ".*" OK\)$/.test(i[0]??""),Bl=class{#t;#e;#n;#i=!1;#s=null;#r;training=E("button",{type:"button",id:"training","aria-pressed":"false"},"Training: off");#o=E("p",{class:"quiet",id:"teach-hint",role:"status"});#a=E("input",{id:"learn-name",list:"learned-names",placeholder:"a name, or none yet",...$u});#l=E("datalist",{id:"learned-names"});panel;constructor(t,e,n){this.#t=t,this.#e=e,this.#n=n,this.#r=new Ol(e,{accept:s=>this.#g(s),reject:()=>this.#m()}),this.training.addEventListener("click",()=>this.#h(!this.#c)),this.panel=E("div",{class:"teaching"},E("div",{class:"row"},this.training,E("label",{for:"learn-name"},"Name"),this.#a),this.#l,this.#o,this.#r.panel),e.onChange(()=>{this.#f(),this.#i||this.#r.showSample()}),this.#f()}get#c(){return this.training.getAttribute("aria-pressed")==="true"}#h(t){this.training.setAttribute("aria-pressed",String(t)),this.training.textContent=`Training: ${t?"on":"off"}`,document.body.classList.toggle("training",t),this.#f()}#u(t){this.#o.textContent=t}#f(){let t=this.#e.names().filter(n=>n!==this.#n());if(this.#l.replaceChildren(...t.map(n=>E("option",{value:n}))),this.#i)return;let e=t.includes(Vs)?"":" Begin with the end-effector: the triangle on the gripper.";this.#u(this.#c?`Click on a mark in the camera\u2019s image.${e}`:"Switch training on, and click on a mark."),this.#c&&e&&this.#a.value===""&&(this.#a.value=Vs)}more(t){this.#h(!0),this.#a.value=t}take(t){return this.#c?(this.#i||!this.#a.reportValidity()||this.#d(t,this.#a.value||this.#n()),!0):!1}async#d(t,e){this.#i=!0,this.#r.hide(),this.#u(`Learning what is at ${t.x}, ${t.y} of frame ${t.frame}: red while it is filled, then its border.`);let n=this.#e.newest(e)?.num??0;try{let s=await this.#t.values(Ht("learn"),t.x,t.y,t.frame,e);if(!_v(s))throw{said:`${s[0]??"FAIL"}: ${qu(s)}`};this.#s=e,this.#r.open({name:e,isNew:e===this.#n(),before:n}),this.#u("Learned. Accept it under a name, or reject it.")}catch(s){this.#u(`${Te(s)}. For one more sample of an object write its name first; then click again.`)}this.#i=!1}async#p(t,e,n){let s=this.#s;if(this.#i||s===null)return;this.#i=!0,this.#u(t);let r=n;try{await e(s),this.#s=null,this.#r.hide(),this.#a.value=""}catch(o){r=Te(o)}this.#i=!1,this.#f(),this.#u(r)}#g(t){let e=async n=>{t!==n&&await this.#t.values(Ht("rename"),n,t),this.#s=t,this.#r.rename(t),await this.#t.values(Ht("accept"),t)};return this.#p(`Accepting ${t} \u2026`,e,`${t} is accepted. Click on the next mark.`)}#m(){let t=e=>this.#t.values(Ht("reject"),e);return this.#p("Rejecting \u2026",t,"Rejected: nothing was learned.")}};function _m(i,t){let e=c=>i.filter(([,h])=>h===c).map(([h])=>h),n=c=>Bn(c,t),s=e("tracking"),r=e("learning"),o=s.length?`${s.map(n).join(", ")} ${s.includes(t)?"track":"tracks"}, which excludes learning: end that first`:"",a=r.length?`${n(r[0])} ${r[0]===t?"are":"is"} learning`:"",l=e("connected").includes(t);return{connect:l?"you are connected":"",disconnect:l?"":"you are not connected",find:"",train:o||(r.includes(t)?"":a),forget:o||a,track:a,end:s.includes(t)?"":s.length?`${n(s[0])} tracks, and ends it itself`:"nothing is tracked"}}var xm=i=>({connect:i,disconnect:i,find:i,train:i,forget:i,track:i,end:i});function xv(i,t){let e=E("span",{id:"eyes-mode",class:"chip"},"no eyes");return i.follow("eyes","(vision-mode ?eyes ?mode ?connected)",([n])=>{let s=n?$(n[2]):"no eyes";e.textContent=n?`${$(n[1])}: ${s}`:s,e.className=`chip ${n?s==="idle"?"":"busy":"bad"}`,document.body.dataset.eyes=s,t(n?$(n[1]):"",!!n)}),e}function yv(i){let t=E("pre",{class:"answer","aria-label":"What TRACK says",hidden:!0});return i.follow("eyes","(look ?eyes ?frame ?text ?of)",([e])=>{t.hidden=!e,e&&(t.textContent=Xt($(e[3]),1e3))}),t}function ym({connection:i,permission:t,images:e,roles:n},s){let r=new Ll(n),o=new Il(i),a=new Bl(o,r,()=>pm(s().replace(/\D+/g,"-").replace(/^-/,"")));e.onPoint(v=>a.take(v));let l=new Ul(r,o,v=>a.more(v)),c=new Mn("why-eyes"),h=o.button("Connect",Ht("connect")),u=o.button("Disconnect",Ht("disconnect")),f=o.button("End track",Ht("end-track")),d=E("span",{class:"quiet"}),g=!1,y=[],p=()=>{d.textContent=y.map(([b,P])=>`${Bn(b,s())}: ${P}`).join(", "),l.draw();let v=t.command("request")||(g?"":"no eyes are present"),C=v?xm(v):_m(y,s());c.set("Connect",[h],C.connect),c.set("Disconnect",[u],C.disconnect),c.set("End track",[f],C.end),c.set("Training",[a.training],C.train),l.gate(c,C)};r.onChange(p),t.onChange(p);let m=xv(n,(v,C)=>{o.eyes=v||o.eyes,g=C,p()});n.follow("eyes","(vision-held ?eyes ?client ?mode)",v=>{y=v.map(C=>[$(C[2]),$(C[3])]),p()}),n.follow("eyes","(tracked ?eyes ?name ?state ?frame ?confidence)",v=>l.showTracked(v)),_t("eyes").append(gm(i),E("div",{class:"row"},m,d),E("div",{class:"row"},h,u,f),c.note,a.panel,o.panel,yv(n),l.panel)}var vv=4,Sv=60;function vm(i){let[,,t,e,n,s,r]=ut(i);return[t,{text:te(e),teller:n,when:s,because:r}]}async function Mv(i,t,e){let n=[Ht("provenance"),t,...["?id","?fact","?teller","?when","?because"].map(Ht)],s=new Map((await i.ask(n)).map(vm));if(s.set(t,e),![...s.values()].some(({because:a})=>a.some(l=>!s.has(l))))return s;let o=await i.askThen(te(n),e.when).catch(()=>[]);for(let[a,l]of o.map(vm))s.has(a)||s.set(a,{...l,gone:!0});return s}function bv(i,t){if(!t)return E("span",{class:"fact gone"},`fact ${i}, which is not there any more`);let e=t.gone?", gone since":"";return E("span",{class:t.gone?"fact gone":"fact"},E("code",{},Xt(t.text,120)),E("small",{class:"quiet"},`fact ${i}, by ${t.teller} at ${We(t.when)}${e}`))}function Sm(i,t,e,n,s){n.push(i);let o=(t&&s<vv?t.because:[]).slice(0,Math.max(0,Sv-n.length)).map(l=>Sm(l,e.get(l),e,n,s+1)),a=o.length?E("ul",{"aria-label":"because of"},...o):null;return E("li",{},bv(i,t),a)}async function Yu(i,t,e){let n=await Mv(i,t,e);return E("ul",{class:"provenance","aria-label":"Because of what it was told"},Sm(t,e,n,[],0))}function Mm(i,t,e){if(e.because.length===0)return null;let n=E("div",{}),s=`Because of ${e.because.length} fact${e.because.length>1?"s":""}`,r=E("button",{type:"button",class:"because"},s);return r.addEventListener("click",async()=>{r.disabled=!0,n.replaceChildren(await Yu(i,t,e)),r.disabled=!1}),E("div",{},r,n)}var Xr=(i,{teller:t,when:e})=>`fact ${i}, told by ${t} at ${We(e)}`;var Vl=200,kl=i=>i.ids.join();function wv(i){let t=i.length<=24&&i!==""&&Number.isFinite(Number(i));return E("td",{class:t?"number":""},Xt(i,160))}function Tv(i,t,e){let n=i.facts.map((o,a)=>Xr(i.ids[a],o)),s=t.length?t.map(o=>i.bindings[o]??""):[i.facts[0]?.text??"yes"],r=E("button",{type:"button",class:"because","data-ids":kl(i)},"Because \u2026");return E("tr",{title:n.join(`
`),class:e?"new":""},...s.map(wv),E("td",{},r))}function Ev(i,t){if(i.length===0)return E("p",{class:"quiet"},"nothing, now");let e=Object.keys(i[0].bindings),n=(e.length?e:["fact"]).map(r=>E("th",{},r)),s=i.map(r=>Tv(r,e,t(r)));return E("table",{},E("thead",{},E("tr",{},...n,E("td",{}))),E("tbody",{},...s))}var zl=class{#t;#e=[];panel=E("div",{class:"scroll",id:"answers"});because=E("div",{id:"because",role:"group","aria-label":"Reasons",tabindex:0,hidden:!0});constructor(t){this.#t=t,this.panel.addEventListener("pointerdown",e=>this.#n(e)),this.panel.addEventListener("keydown",e=>["Enter"," "].includes(e.key)&&this.#n(e))}begin(){this.#e=[],this.panel.replaceChildren(),this.because.hidden=!0}show(t){let e=new Set(this.#e.map(kl));this.#e=t.slice(0,Vl),this.panel.replaceChildren(Ev(this.#e,n=>e.size>0&&!e.has(kl(n))))}async#n(t){let n=(t.target instanceof Element?t.target.closest("button.because"):null)?.getAttribute("data-ids"),s=this.#e.find(o=>kl(o)===n);if(!s)return;let r=s.facts.map((o,a)=>Yu(this.#t,s.ids[a],o));this.because.replaceChildren(...await Promise.all(r)),this.because.hidden=!1}};var Av=([,i,t])=>`(${$(i)}${t.map(e=>` ?${$(e[0])}`).join("")})`;function Cv(i){return ut(i)[2].filter(e=>Array.isArray(e)&&$(e[0])==="posts").flatMap(e=>e.slice(1)).filter(e=>Array.isArray(e?.[2]))}var Gl=class{#t=new Map;list=E("datalist",{id:"questions"});constructor(t){t.follow("(contract ?name ?form)",e=>{this.#t=new Map(e.flatMap(Cv).map(s=>[$(s[1]),Av(s)]));let n=[...this.#t.values()].sort();this.list.replaceChildren(...n.map(s=>E("option",{value:s})))})}of(t){return this.#t.get(t)}};var Rv=60,Pv=["Relation","Facts","Told/s","Watches","To board","To watcher","Told by"],bm=i=>(i/1e3).toFixed(i<1e4?1:0),wm=i=>i?`${bm(i.p50)} / ${bm(i.p99)}`:"\u2013";function Iv({revision:i,facts:t,transactions_per_second:e,journey:n}){let s=n?`; a fact is committed after ${n.committed_us} \xB5s, acknowledged after ${n.acknowledged_us} \xB5s, delivered after ${n.delivered_us} \xB5s`:"";return`revision ${i}, ${t} facts, ${e.toFixed(1)} transactions/s${s}`}function Tm(i,t,e,n){let s=E("p",{class:"quiet",id:"activity-note"},"\u2026"),r=Li({id:"relations"},Pv),o=new Map,a=h=>(o.has(h)||o.set(h,E("button",{type:"button",class:"small",onclick:()=>e(h)},h)),o.get(h).disabled=!t(h),o.get(h)),l=(h,u)=>{if(!h){s.textContent=u??"";return}s.textContent=Iv(h);let f=h.relations.filter(d=>d.facts||d.told_per_second||d.watches).slice(0,Rv);r.fill(f.toSorted((d,g)=>d.name.localeCompare(g.name)).map(d=>[a(d.name),d.facts,d.told_per_second.toFixed(1),d.watches,wm(d.told_us),wm(d.delivered_us),_s(d.tellers.join(", "),n())]))},c=E("section",{"aria-label":"Relations"},E("h2",{},"Relations"),s,E("p",{class:"quiet"},"Under way to the board and from there, in ms: the half / 99 %. A name that is off stands in no contract, so its form is not known."),E("div",{class:"scroll",tabindex:0,role:"group","aria-label":"Table of relations"},r.panel));return i.shownIn(c,l),c}function Lv(i,t,e,n){let s=()=>{};return r=>{s(),n.hidden=!0,e.textContent="",t.begin();let o=[],a=0,l=si(()=>{let c=o.length+a;e.textContent=`${c} answer${c===1?"":"s"}${c>Vl?`, ${Vl} shown`:""}`,t.show(o)});s=i.watch(r,(c,h)=>{o=c,a=h.resynchronised?h.cut:a+h.cut,l()},c=>{n.hidden=!1,n.textContent=Te(c)})}}function Em(i,t,e){let n=new Gl(i),s=new zl(i),r={id:"query",spellcheck:"false",list:n.list.id,placeholder:"(on ?x ?y)","aria-label":"Question"},o=E("input",r),a=E("span",{class:"quiet",id:"query-count"}),l=E("pre",{class:"answer bad",id:"query-wrong",hidden:!0}),c=E("button",{type:"submit",class:"strong"},"Watch"),h=E("form",{class:"row"},o,n.list,c,a),u=Lv(i,s,a,l);h.addEventListener("submit",d=>{d.preventDefault(),u(o.value)});let f=Tm(t,d=>n.of(d)!==void 0,d=>{o.value=n.of(d)??"",h.requestSubmit()},e);_t("facts").append(h,l,s.because,s.panel,f)}function Am(i){let t=_t("hands-note"),e=E("span",{}),n=E("button",{type:"button"});t.append(e,n);let s=()=>{};n.addEventListener("click",()=>s());let r=(c,h,u)=>{t.hidden=c==="",e.textContent!==c&&(e.textContent=c),n.textContent=h,s=u},o=()=>i.toggle().catch(c=>e.textContent=Te(c)),a=()=>{i.change=null,l()},l=()=>{let{change:c,mine:h}=i,[u]=i.askers;return c&&!c.to?r("You no longer have the arm in hand.","OK",a):c&&c.to!=="you"?r(`${c.to} has taken the arm over.`,"OK",a):h&&u?r(`${u} asks for the arm.`,`Let ${u} have it`,o):c&&h?r(`You have taken the arm over from ${c.from}, who is told.`,"OK",a):r("","",()=>{})};i.onChange(l)}function Nv(i,t){let[,,,,e,n,s]=i,r=o=>Math.atan(o/e)*180/Math.PI;return{pan:r(t.x-n),tilt:-r(t.y-s)}}function Cm(i,t,e){let n=E("input",{type:"checkbox",id:"click-to-look"}),s,r;return i.follow("(head ?pan ?tilt ?state)",([o])=>s=o&&ut(o)),i.follow("(camera-model ?eyes ?width ?height ?focal ?cx ?cy ?base)",([o])=>r=o&&ut(o)),t.onPoint(o=>{if(!n.checked||!s||!r)return!1;let a=Nv(r,o);return e(`(set-pan-pos ${(s[1]+a.pan).toFixed(2)})`),e(`(set-tilt-pos ${(s[2]+a.tilt).toFixed(2)})`),!0}),n}var Rm=[{name:"pan",label:"Pan left / right",index:1},{name:"tilt",label:"Tilt down / up",index:2}];function Uv({name:i,label:t},e){let n=Rl({label:t,unit:"\xB0",most:30,form:c=>`(set-${i}-rel-pos ${c})`},e),s=jo({label:`${t.split(" ")[0]} speed`,unit:"%",least:1,most:100,value:20,form:c=>`(set-${i}-speed ${c})`},e),r=E("input",{type:"number",id:`${i}-place`,step:"any",required:!0,size:6,"aria-label":`${i} to, degrees`}),o=E("button",{type:"submit"},"Move to"),a=E("button",{type:"button",onclick:()=>e(`(reset-${i})`)},`Reset ${i}`),l=E("form",{class:"row"},E("label",{for:r.id},i),r,"\xB0",o,a);return l.addEventListener("submit",c=>{c.preventDefault(),e(`(set-${i}-pos ${Number(r.value)})`)}),{rows:[n.row,s.row],form:l,percent:s,controls:[n.input,s.input,r,o,a]}}function Fv(i,t){let e=E("output",{"aria-label":"Where the head looks"},"");return i.follow("(head ?pan ?tilt ?state)",([n])=>{let[,s,r,o]=n?ut(n):[];e.textContent=n?`pan ${s.toFixed(1)}\xB0, tilt ${r.toFixed(1)}\xB0, ${$(o)}`:""}),i.follow("(head-speed ?pan ?tilt)",([n])=>{n&&Rm.forEach((s,r)=>t[r].percent.put(ut(n)[s.index]))}),e}function Pm(i,t,e,n){let s=new Gr(i,()=>"pan-tilt",n,"Commands that the head received, newest first"),r=y=>s.send(y),o=E("span",{id:"head-light",class:"chip"},"no head is present"),a=Rm.map(y=>Uv(y,r)),l=(y,p)=>E("button",{type:"button",onclick:()=>r(p)},y),c=[l("Connect","(pt-init)"),l("Disconnect","(pt-close)"),l("Reset both","(reset-all)"),l("Look ahead","(look-ahead)")],h=Cm(i,e,r),u=[...c,h,...a.flatMap(y=>y.controls)],f=new Mn("why-head");_t("head").append(E("div",{class:"row"},o,Fv(i,a),...c),f.note,E("div",{class:"slides"},...a.flatMap(y=>y.rows)),...a.map(y=>y.form),E("label",{class:"row"},h,"A click in the camera\u2019s image turns the head there"),E("h2",{},"Commands received"),s.list);let d,g=()=>{let y=d?$(d[1]):"no head is present";o.textContent=d&&$(d[2])?`${y}: ${$(d[2])}`:y,o.className=`chip ${y==="ready"?"good":"bad"}`;let p=d?"":"This cell has no head that turns, or its agent is away";f.set("Whatever turns the head",u,t.command("request")||p)};t.onChange(g),i.follow("(pan-tilt ?state ?trouble)",([y])=>{d=y&&ut(y),g()})}function Im(i){let t=location.protocol==="https:";_t("refused-here").hidden=t,_t("log-in").hidden=!t,_t("log-out").hidden=!t,_t("log-out").addEventListener("click",()=>i.logOut());let e=!1;return _t("log-in").addEventListener("submit",n=>{n.preventDefault(),e=!0,_t("log-in-wrong").textContent="",i.logIn(_t("token").value.trim()),_t("token").value=""}),(n,s="")=>{n==="live"&&(e=!1,_t("refused").close()),n==="refused"&&(_t("log-in-wrong").textContent=e?"This token is wrong.":s),n==="refused"&&!_t("refused").open&&_t("refused").showModal()}}function Lm(i){let t=E("canvas",{width:640,height:480,role:"img","aria-label":i}),e=E("span",{class:"quiet"},"no eyes are present"),n=E("figure",{class:"card"},t,E("figcaption",{},E("span",{},i),e));return{canvas:t,note:e,card:n,stream:"",shown:null,end:()=>{}}}function Hl(i,t){(i.width!==t.width||i.height!==t.height)&&(i.width=t.width,i.height=t.height),Qi(i).drawImage(t.bitmap,0,0,t.width,t.height)}function Dm(i,t){let{canvas:e}=i;Hl(e,t),i.shown={number:t.number,width:t.width,height:t.height},i.note.textContent=`frame ${t.number}`,e.dataset.captured=String(t.captured),e.dataset.frame=String(t.number)}async function Nm(i,t,e,n){t.shown=null,t.note.textContent="looking for what was kept \u2026";try{let s=await i.picture(t.stream,e);n()&&(Hl(t.canvas,s),t.note.textContent=`frame ${s.number}, ${We(s.captured)}`),s.bitmap.close()}catch(s){if(!n())return;Qi(t.canvas).clearRect(0,0,t.canvas.width,t.canvas.height),t.note.textContent=Te(s)}}function Um(i,t){if(!i.shown)return null;let{width:e,height:n,number:s}=i.shown,r=i.canvas.getBoundingClientRect(),o=Math.min(r.width/e,r.height/n),a=Math.round((t.clientX-r.left-(r.width-o*e)/2)/o),l=Math.round((t.clientY-r.top-(r.height-o*n)/2)/o);return a>=0&&l>=0&&a<e&&l<n?{x:a,y:l,frame:s}:null}var Ov={closed:"the camera is closed: Connect, in Eyes, opens it",opening:"the camera opens",lost:"the camera is lost"},Fm=[{kinds:["colour","left"],title:"Camera"},{kinds:["annotated"],title:"What the eyes follow"}];function Bv(i,t,e){i.followAlways("(camera-state ?eyes ?state ?trouble)",n=>{let s=n.map(ut),[,,r,o]=s.find(a=>$(a[1])===t.server("eyes"))??s[0]??[];e(r===void 0?"no eyes are present":Ov[$(r)],$(o??""))})}function kv(i,t,e){let n=[],s=o=>{let a=n.filter(l=>$(l[2])===o).map(l=>$(l[1]));return a.find(l=>l===`${t.server("eyes")}-${o}`)??a[0]},r=()=>e(Fm.map(({kinds:o})=>o.map(s).find(Boolean)??""));i.followAlways("(stream ?name ?kind ?place)",o=>{n=o.map(ut),r()}),t.onChange(r)}function zv(i){let t=[];return i.canvas.classList.add("clickable"),i.canvas.addEventListener("click",e=>{let n=Um(i,e);n&&t.some(s=>s(n))}),t}function Om(i,t){let e=Fm.map(o=>Lm(o.title));_t("images").append(...e.map(o=>o.card));let n=null,s=(o,a)=>{a!==o.stream&&(o.end(),o.stream=a,o.canvas.dataset.stream=a,o.end=a?i.look(a,l=>n===null&&Dm(o,l)):()=>{},a||(o.note.textContent="no such stream"))};kv(i,t,o=>e.forEach((a,l)=>s(a,o[l]))),Bv(i,t,(o,a)=>{if(n!==null)return;let l=Xt([o,a].filter(Boolean).join(": "),120);for(let c of e)(o||!c.shown)&&(c.note.textContent=o?l:"no image yet")});let r=zv(e[0]);return{onPoint:o=>r.push(o),showMoment:o=>{n=o;let a=()=>n===o;for(let l of e)o!==null&&l.stream&&Nm(i,l,o,a)},telling:()=>e[1].stream||e[0].stream}}var Vv={connecting:"connecting",live:"live",silent:"silent",lost:"no connection",refused:"no session",outdated:"of another version"},Gv=["want","eyes","drive","head"];function Bm(i){let t=_t("state");return(e,n="")=>{let s=e==="live",r=[Vv[e],Xt(n,160)].filter(Boolean).join(e==="silent"?" ":": ");t.textContent!==r&&(t.textContent=r),t.className=`chip ${s?"good":"bad"}`,document.body.dataset.state=e,e!=="connecting"&&(_t("line-note").hidden=s);for(let o of Gv)_t(o).inert=!s;i.set({live:s})}}var Wl=class{#t=!1;#e=!1;#n={};#i=[];set({live:t=this.#t,past:e=this.#e,mayNot:n=this.#n}){this.#t=t,this.#e=e,this.#n=n;for(let s of this.#i)s()}onChange(t){this.#i.push(t),t()}get live(){return this.#t}get line(){return this.#t?"":"There is no live line to the console"}get past(){return this.#e?"You look at the past: press Now first":""}right(...t){return t.map(e=>this.#n[e]).find(Boolean)??""}command(...t){return this.line||this.right(...t)||this.past}};var Hv=/^\s*(\d{1,2}):(\d{2})(?::(\d{2}))?\s*$/,km=i=>[i.getFullYear(),i.getMonth()+1,i.getDate()].map(t=>String(t).padStart(2,"0")).join("-"),qr=()=>km(new Date),ea=i=>km(new Date(i/1e3)),hr=i=>ea(i)===qr()?We(i):`${ea(i)} ${We(i)}`;function Wv(i,t,e){let[,n,s,r]=i.match(Hv)?.map(Number)??[];if(n===void 0||n>23||s>59||r>59)return{wrong:"write a time as 14:03 or 14:03:20"};let[o,a,l]=(t||qr()).split("-").map(Number),c=new Date(o,a-1,l,n,s,r||0).getTime()*1e3;return c>Date.now()*1e3?{wrong:`${hr(c)} is yet to come`}:c<e?{wrong:`nothing is known from before ${hr(e)}`}:{moment:c}}var Xl=class{#t=0;#e=!1;#n=E("input",{id:"moment-time",size:8,maxlength:8,placeholder:"hh:mm:ss",spellcheck:"false","aria-label":"Time of day"});#i=E("input",{id:"moment-date",type:"date","aria-label":"Day",hidden:!0});#s=E("button",{type:"submit"},"Go to");controls=[this.#n,this.#i,this.#s];form=E("form",{class:"row",autocomplete:"off"},this.#i,this.#n,this.#s);constructor(t){this.form.addEventListener("submit",e=>{e.preventDefault();let n=Wv(this.#n.value,this.#i.value,this.#t);if(this.#n.setCustomValidity("wrong"in n?n.wrong:""),!("moment"in n))return this.#n.reportValidity();this.#e=!1,t(n.moment)}),this.#n.addEventListener("input",()=>{this.#e=!0,this.#n.setCustomValidity("")}),this.#n.addEventListener("blur",()=>this.#e=!1)}since(t){this.#t=t,this.#i.hidden=ea(t)===qr(),this.#i.min=ea(t),this.#i.max=qr(),this.#i.value||(this.#i.value=qr())}show(t){this.#e||document.activeElement===this.#i||(this.#n.value=t===null?"":We(t),this.#i.value=t===null?qr():ea(t))}};var Zu=1e6,Xv=1e3,zm=500;function qv(i){let t=(e,n,s)=>E("button",{type:"button","aria-label":s,title:s,onclick:()=>i(e)},n);return[t(-1,"\u25C2 Entry","The entry of the story before"),t(1,"Entry \u25B8","The entry of the story after")]}var Ju=class{#t;#e=0;#n=0;#i=!1;#s=null;#r=-zm;#o;#a="";#l=E("input",{type:"range",id:"moment",min:0,max:1,step:1,value:1,"aria-label":"Back in time, by seconds"});#c=E("output",{id:"moment-note",for:"moment"},"now");#h=E("button",{type:"button",id:"back-to-now",disabled:!0,onclick:()=>this.goTo(null)},"Now");#u=new Xl(t=>this.goTo(t));#f=qv(t=>this.#_(t));#d=new Mn("why-no-past");constructor(t){this.#t=t;let{connection:e,permission:n}=t;_t("past").append(E("label",{for:"moment"},"Time"),this.#l,...this.#f,this.#u.form,this.#c,this.#h,this.#d.note),this.#l.addEventListener("input",()=>this.#c.textContent=hr(this.#g()??Date.now()*1e3)),this.#l.addEventListener("change",()=>this.goTo(this.#g())),this.#l.addEventListener("keydown",s=>this.#v(s)),e.followAlways("(agent ?name ?kind ?host)",s=>this.#x(s)),e.followAlways("(event ?n ?kind ?sentence ?detail)",s=>this.#x(s)),n.onChange(()=>this.#S()),setInterval(()=>this.#y(),Xv)}goTo(t){this.#s=t,this.#m(t),this.#c.textContent=`${t===null?"now":hr(t)} \u2026`,clearTimeout(this.#o);let e=this.#r+zm-performance.now();e>0?this.#o=setTimeout(()=>this.#p(t),e):this.#p(t)}async#p(t){let{connection:e,permission:n,images:s}=this.#t;this.#r=performance.now(),document.body.classList.toggle("past",t!==null),n.set({past:t!==null}),this.#h.disabled=t===null,t===null&&(this.#c.textContent="now"),s.showMoment(t);let r=await e.showMoment(t);t===null||this.#s!==t||(this.#c.textContent=r?Te(r):`as it was at ${hr(t)}`)}#g(){let t=Number(this.#l.value);return t===Number(this.#l.max)?null:this.#e+t*Zu}#m(t){let e=Math.max(1,Math.ceil((Date.now()*1e3-this.#e)/Zu));this.#l.max=String(e),this.#l.value=String(t===null?e:Math.min(Math.max(Math.round((t-this.#e)/Zu),0),e-1)),this.#l.setAttribute("aria-valuetext",t===null?"now":hr(t)),this.#u.show(t)}#y(){this.#l.matches(":active")||this.#m(this.#s)}#_(t){let e=this.#s??1/0,n=this.#t.entries.until(1/0).map(({facts:r})=>r[0].when),s=t<0?n.findLast(r=>r<e):n.find(r=>r>e);(s!==void 0||t>0)&&this.goTo(s??null)}#v(t){t.key!=="PageUp"&&t.key!=="PageDown"||(t.preventDefault(),this.#_(t.key==="PageUp"?1:-1))}#x(t){let e=t.map(({facts:n})=>n[0].when);e.length!==0&&(this.#e=Math.min(this.#e||1/0,...e),this.#n=Math.max(this.#n,...e),this.#u.since(this.#e),this.#S())}async#M(){this.#i=!0;try{await this.#t.connection.askThen("(agent ?name ?kind ?host)",this.#n),this.#a=""}catch(t){this.#a=t.sentence??Te(t)}this.#S()}#S(){let{permission:t}=this.#t;t.live?!this.#i&&this.#n&&this.#M():this.#i=!1;let e=t.line||(this.#n?this.#a:"nothing is known yet");this.#d.set("Back in time",[this.#l,...this.#f,...this.#u.controls],e)}};function Vm(i){let t=new Ju(i);return e=>t.goTo(e)}function $v(i,t){let e=Array.from({length:i.length+1},()=>Array(t.length+1).fill(0));for(let o=i.length-1;o>=0;--o)for(let a=t.length-1;a>=0;--a)e[o][a]=i[o]===t[a]?e[o+1][a+1]+1:Math.max(e[o+1][a],e[o][a+1]);let n=[],s=0,r=0;for(;s<i.length||r<t.length;)s<i.length&&r<t.length&&i[s]===t[r]?n.push([i[s++],t[r++]]):r===t.length||s<i.length&&e[s+1][r]>=e[s][r+1]?n.push([i[s++],null]):n.push([null,t[r++]]);return n}function Gm(i,t,e){let n=(r,o,a)=>E("td",{class:r?o:""},r&&E("code",{},Xt(r,80)),r&&a&&E("small",{},` ${a}`)),s=$v(i.map(te),t.map(te)).map(([r,o])=>E("tr",{},n(r,o?"kept":"dropped",o?"":e.has(r??"")?"begun":"dropped"),n(o,r?"kept":"made",r?"kept":"new")));return E("table",{class:"plans"},E("thead",{},E("tr",{},E("th",{},"The plan before"),E("th",{},"From here on"))),E("tbody",{},...s))}function xs(i){if(!Array.isArray(i)||$(i[0])!=="plan")return null;let[,t,e]=i;return Array.isArray(e)?{goal:t,operations:e}:null}var Yv=(i,t)=>t.every((e,n)=>e===i[i.length-t.length+n]);function Zv(i,t,e){let n=e.findLastIndex(s=>{let r=xs(s[4]);return r!==null&&r.goal===i&&r.operations.map(te).join()===t.join()});return e.slice(n+1)}function Hm(i,t,e){let[,n,s]=i,r=s.map(te),o=new Set,a=new Set,l=1/0;for(let[,,u,,f]of Zv(n,r,e.map(ut))){let d=xs(f)?.operations.map(te);if($(u)==="operation")o.add(te(f));else if(d&&d.length<r.length&&Yv(r,d)){l=r.length-d.length;for(let g of r.slice(l))for(let y of[o,a])y.delete(g)}else if($(u)==="difference"&&Array.isArray(f))for(let g of f.map(te))r.includes(g)&&a.add(g)}let c=t&&ut(t),h=c&&te(c[2])===r[c[1]];return r.map((u,f)=>h&&f===c[1]?$(c[3]):h&&f<c[1]?a.has(u)?"skipped":"done":a.has(u)?"skipped":f>=l?"still serves":"")}var Jv={"still serves":"serves"};function Kv(i,t){let e=_t("plan");if(e.replaceChildren(),_t("plan-note").textContent=i?`for goal ${i[1]}`:"none yet",!i)return;i[2].forEach((s,r)=>{let o=t[r],a=E("li",{class:Jv[o]??o},E("code",{},Xt(te(s),80)));o&&a.append(E("span",{class:"mark"},o)),o==="running"&&a.setAttribute("aria-current","step"),e.append(a)});let n=e.querySelector(".running");n instanceof HTMLElement&&(e.scrollTop=n.offsetTop-e.offsetTop-e.clientHeight/2)}function Wm(i,t){let e,n,s=si(()=>{let r=t.until(i.moment??1/0);Kv(e,e?Hm(e,n,r):[])});t.onChange(s),i.follow("(plan ?n ?operations)",r=>{e=r.length?ut(r[0]):void 0,s()}),i.follow("(operation ?i ?operation ?state)",r=>{n=r[0],s()})}/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */var js={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Qs={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},Mg=0,Cf=1,bg=2;var za=1,wg=2,wo=3,tr=0,ni=1,oi=2,yr=0,To=1,Rf=2,Pf=3,If=4,Tg=5;var vr=100,Eg=101,Ag=102,Cg=103,Rg=104,Pg=200,Ig=201,Lg=202,Dg=203,Lf=204,Df=205,Ng=206,Ug=207,Fg=208,Og=209,Bg=210,kg=211,zg=212,Vg=213,Gg=214,Mc=0,bc=1,wc=2,fo=3,Tc=4,Ec=5,Ac=6,Cc=7,Nf=0,Hg=1,Wg=2,ls=0,Uf=1,Ff=2,Of=3,Bf=4,kf=5,zf=6,Vf=7;var Gf=300,Sr=301,Eo=302,eh=303,nh=304,Rc=1e3,ns=1001,Pc=1002,Un=1003,Xg=1004;var Va=1005;var Qn=1006,ih=1007;var Cs=1008;var ai=1009,Hf=1010,Wf=1011,Ao=1012,sh=1013,Bi=1014,ki=1015,zi=1016,rh=1017,oh=1018,Mr=1020,Xf=35902,qf=35899,$f=1021,Yf=1022,Vi=1023,Ts=1026,Rs=1027,Zf=1028,ah=1029,er=1030,lh=1031;var ch=1033,Ga=33776,Ha=33777,Wa=33778,Xa=33779,hh=35840,uh=35841,fh=35842,dh=35843,ph=36196,mh=37492,gh=37496,_h=37488,xh=37489,qa=37490,yh=37491,vh=37808,Sh=37809,Mh=37810,bh=37811,wh=37812,Th=37813,Eh=37814,Ah=37815,Ch=37816,Rh=37817,Ph=37818,Ih=37819,Lh=37820,Dh=37821,Nh=36492,Uh=36494,Fh=36495,Oh=36283,Bh=36284,$a=36285,kh=36286;var fa=2300,Ic=2301,vc=2302,Sf=2303,Mf=2400,bf=2401,wf=2402;var qg=3200;var zh=0,$g=1,Ps="",Kn="srgb",da="srgb-linear",pa="linear",Le="srgb";var Sc=7680;var Yg=519,Zg=512,Jg=513,Kg=514,Jf=515,jg=516,Qg=517,Kf=518,jf=519,Qf=35044;var td="300 es",Ti=2e3,po=2001;function jv(i){for(let t=i.length-1;t>=0;--t)if(i[t]>=65535)return!0;return!1}function Qv(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function ma(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function t0(){let i=ma("canvas");return i.style.display="block",i}var Xm={},mo=null;function ga(...i){let t="THREE."+i.shift();mo?mo("log",t,...i):console.log(t,...i)}function e0(i){let t=i[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=i[1];e&&e.isStackTrace?i[0]+=" "+e.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function jt(...i){i=e0(i);let t="THREE."+i.shift();if(mo)mo("warn",t,...i);else{let e=i[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...i)}}function se(...i){i=e0(i);let t="THREE."+i.shift();if(mo)mo("error",t,...i);else{let e=i[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...i)}}function ha(...i){let t=i.join(" ");t in Xm||(Xm[t]=!0,jt(...i))}function n0(i,t,e){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(t,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:n()}}setTimeout(r,e)})}var i0={[Mc]:Mc,[wc]:Ac,[Tc]:Tc,[fo]:Ec,[bc]:bc,[Ac]:wc,[Cc]:Cc,[Ec]:fo},Oi=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[t]===void 0&&(n[t]=[]),n[t].indexOf(e)===-1&&n[t].push(e)}hasEventListener(t,e){let n=this._listeners;return n===void 0?!1:n[t]!==void 0&&n[t].indexOf(e)!==-1}removeEventListener(t,e){let n=this._listeners;if(n===void 0)return;let s=n[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let n=e[t.type];if(n!==void 0){t.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},Gn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],qm=1234567,ho=Math.PI/180,go=180/Math.PI;function nr(){let i=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(Gn[i&255]+Gn[i>>8&255]+Gn[i>>16&255]+Gn[i>>24&255]+"-"+Gn[t&255]+Gn[t>>8&255]+"-"+Gn[t>>16&15|64]+Gn[t>>24&255]+"-"+Gn[e&63|128]+Gn[e>>8&255]+"-"+Gn[e>>16&255]+Gn[e>>24&255]+Gn[n&255]+Gn[n>>8&255]+Gn[n>>16&255]+Gn[n>>24&255]).toLowerCase()}function ye(i,t,e){return Math.max(t,Math.min(e,i))}function ed(i,t){return(i%t+t)%t}function tS(i,t,e,n,s){return n+(i-t)*(s-n)/(e-t)}function eS(i,t,e){return i!==t?(e-i)/(t-i):0}function ua(i,t,e){return(1-e)*i+e*t}function nS(i,t,e,n){return ua(i,t,1-Math.exp(-e*n))}function iS(i,t=1){return t-Math.abs(ed(i,t*2)-t)}function sS(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*(3-2*i))}function rS(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*i*(i*(i*6-15)+10))}function oS(i,t){return i+Math.floor(Math.random()*(t-i+1))}function aS(i,t){return i+Math.random()*(t-i)}function lS(i){return i*(.5-Math.random())}function cS(i){i!==void 0&&(qm=i);let t=qm+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function hS(i){return i*ho}function uS(i){return i*go}function fS(i){return i>0&&Number.isInteger(i)&&2**Math.round(Math.log2(i))===i}function dS(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function nd(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function pS(i,t,e,n,s){let r=Math.cos,o=Math.sin,a=r(e/2),l=o(e/2),c=r((t+n)/2),h=o((t+n)/2),u=r((t-n)/2),f=o((t-n)/2),d=r((n-t)/2),g=o((n-t)/2);switch(s){case"XYX":i.set(a*h,l*u,l*f,a*c);break;case"YZY":i.set(l*f,a*h,l*u,a*c);break;case"ZXZ":i.set(l*u,l*f,a*h,a*c);break;case"XZX":i.set(a*h,l*g,l*d,a*c);break;case"YXY":i.set(l*d,a*h,l*g,a*c);break;case"ZYZ":i.set(l*g,l*d,a*h,a*c);break;default:jt("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Vh(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function id(i,t){if(t.constructor===Float32Array)return i;let e=Vh(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/e,-1)}function sd(i,t){if(t.constructor===Float32Array)return i;let e=Vh(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*e)}var rd={DEG2RAD:ho,RAD2DEG:go,generateUUID:nr,clamp:ye,euclideanModulo:ed,mapLinear:tS,inverseLerp:eS,lerp:ua,damp:nS,pingpong:iS,smoothstep:sS,smootherstep:rS,randInt:oS,randFloat:aS,randFloatSpread:lS,seededRandom:cS,degToRad:hS,radToDeg:uS,isPowerOfTwo:fS,ceilPowerOfTwo:dS,floorPowerOfTwo:nd,setQuaternionFromProperEuler:pS,normalize:sd,denormalize:id},Jt=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,n=this.y,s=t.elements;return this.x=s[0]*e+s[3]*n+s[6],this.y=s[1]*e+s[4]*n+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=ye(this.x,t.x,e.x),this.y=ye(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=ye(this.x,t,e),this.y=ye(this.y,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ye(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(ye(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y;return e*e+n*n}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let n=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*n-o*s+t.x,this.y=r*s+o*n+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},ti=class{constructor(t=0,e=0,n=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=n,this._w=s}static slerpFlat(t,e,n,s,r,o,a){let l=n[s+0],c=n[s+1],h=n[s+2],u=n[s+3],f=r[o+0],d=r[o+1],g=r[o+2],y=r[o+3];if(u!==y||l!==f||c!==d||h!==g){let p=l*f+c*d+h*g+u*y;p<0&&(f=-f,d=-d,g=-g,y=-y,p=-p);let m=1-a;if(p<.9995){let v=Math.acos(p),C=Math.sin(v);m=Math.sin(m*v)/C,a=Math.sin(a*v)/C,l=l*m+f*a,c=c*m+d*a,h=h*m+g*a,u=u*m+y*a}else{l=l*m+f*a,c=c*m+d*a,h=h*m+g*a,u=u*m+y*a;let v=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=v,c*=v,h*=v,u*=v}}t[e]=l,t[e+1]=c,t[e+2]=h,t[e+3]=u}static multiplyQuaternionsFlat(t,e,n,s,r,o){let a=n[s],l=n[s+1],c=n[s+2],h=n[s+3],u=r[o],f=r[o+1],d=r[o+2],g=r[o+3];return t[e]=a*g+h*u+l*d-c*f,t[e+1]=l*g+h*f+c*u-a*d,t[e+2]=c*g+h*d+a*f-l*u,t[e+3]=h*g-a*u-l*f-c*d,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,n,s){return this._x=t,this._y=e,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let n=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(n/2),h=a(s/2),u=a(r/2),f=l(n/2),d=l(s/2),g=l(r/2);switch(o){case"XYZ":this._x=f*h*u+c*d*g,this._y=c*d*u-f*h*g,this._z=c*h*g+f*d*u,this._w=c*h*u-f*d*g;break;case"YXZ":this._x=f*h*u+c*d*g,this._y=c*d*u-f*h*g,this._z=c*h*g-f*d*u,this._w=c*h*u+f*d*g;break;case"ZXY":this._x=f*h*u-c*d*g,this._y=c*d*u+f*h*g,this._z=c*h*g+f*d*u,this._w=c*h*u-f*d*g;break;case"ZYX":this._x=f*h*u-c*d*g,this._y=c*d*u+f*h*g,this._z=c*h*g-f*d*u,this._w=c*h*u+f*d*g;break;case"YZX":this._x=f*h*u+c*d*g,this._y=c*d*u+f*h*g,this._z=c*h*g-f*d*u,this._w=c*h*u-f*d*g;break;case"XZY":this._x=f*h*u-c*d*g,this._y=c*d*u-f*h*g,this._z=c*h*g+f*d*u,this._w=c*h*u+f*d*g;break;default:jt("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let n=e/2,s=Math.sin(n);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,n=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],h=e[6],u=e[10],f=n+a+u;if(f>0){let d=.5/Math.sqrt(f+1);this._w=.25/d,this._x=(h-l)*d,this._y=(r-c)*d,this._z=(o-s)*d}else if(n>a&&n>u){let d=2*Math.sqrt(1+n-a-u);this._w=(h-l)/d,this._x=.25*d,this._y=(s+o)/d,this._z=(r+c)/d}else if(a>u){let d=2*Math.sqrt(1+a-n-u);this._w=(r-c)/d,this._x=(s+o)/d,this._y=.25*d,this._z=(l+h)/d}else{let d=2*Math.sqrt(1+u-n-a);this._w=(o-s)/d,this._x=(r+c)/d,this._y=(l+h)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let n=t.dot(e)+1;return n<1e-8?(n=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=n):(this._x=0,this._y=-t.z,this._z=t.y,this._w=n)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=n),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(ye(this.dot(t),-1,1)))}rotateTowards(t,e){let n=this.angleTo(t);if(n===0)return this;let s=Math.min(1,e/n);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let n=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,h=e._w;return this._x=n*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-n*c,this._z=r*h+o*c+n*l-s*a,this._w=o*h-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){let n=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(n=-n,s=-s,r=-r,o=-o,a=-a);let l=1-e;if(a<.9995){let c=Math.acos(a),h=Math.sin(c);l=Math.sin(l*c)/h,e=Math.sin(e*c)/h,this._x=this._x*l+n*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this._onChangeCallback()}else this._x=this._x*l+n*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this.normalize();return this}slerpQuaternions(t,e,n){return this.copy(t).slerp(e,n)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},G=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,n=0){this.x=t,this.y=e,this.z=n}set(t,e,n){return n===void 0&&(n=this.z),this.x=t,this.y=e,this.z=n,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion($m.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion($m.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*n+r[6]*s,this.y=r[1]*e+r[4]*n+r[7]*s,this.z=r[2]*e+r[5]*n+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,n=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*n),h=2*(a*e-r*s),u=2*(r*n-o*e);return this.x=e+l*c+o*u-a*h,this.y=n+l*h+a*c-r*u,this.z=s+l*u+r*h-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*n+r[8]*s,this.y=r[1]*e+r[5]*n+r[9]*s,this.z=r[2]*e+r[6]*n+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=ye(this.x,t.x,e.x),this.y=ye(this.y,t.y,e.y),this.z=ye(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=ye(this.x,t,e),this.y=ye(this.y,t,e),this.z=ye(this.z,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ye(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let n=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let n=t.dot(this)/e;return this.copy(t).multiplyScalar(n)}projectOnPlane(t){return Ku.copy(this).projectOnVector(t),this.sub(Ku)}reflect(t){return this.sub(Ku.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(ye(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y,s=this.z-t.z;return e*e+n*n+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,n){let s=Math.sin(e)*t;return this.x=s*Math.sin(n),this.y=Math.cos(e)*t,this.z=s*Math.cos(n),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,n){return this.x=t*Math.sin(e),this.y=n,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),n=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=n,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,n=Math.sqrt(1-e*e);return this.x=n*Math.cos(t),this.y=e,this.z=n*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Ku=new G,$m=new ti,oe=class{static{this.prototype.isMatrix3=!0}constructor(t,e,n,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,l,c)}set(t,e,n,s,r,o,a,l,c){let h=this.elements;return h[0]=t,h[1]=s,h[2]=a,h[3]=e,h[4]=r,h[5]=l,h[6]=n,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],this}extractBasis(t,e,n){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],h=n[4],u=n[7],f=n[2],d=n[5],g=n[8],y=s[0],p=s[3],m=s[6],v=s[1],C=s[4],b=s[7],P=s[2],A=s[5],x=s[8];return r[0]=o*y+a*v+l*P,r[3]=o*p+a*C+l*A,r[6]=o*m+a*b+l*x,r[1]=c*y+h*v+u*P,r[4]=c*p+h*C+u*A,r[7]=c*m+h*b+u*x,r[2]=f*y+d*v+g*P,r[5]=f*p+d*C+g*A,r[8]=f*m+d*b+g*x,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8];return e*o*h-e*a*c-n*r*h+n*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],u=h*o-a*c,f=a*l-h*r,d=c*r-o*l,g=e*u+n*f+s*d;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let y=1/g;return t[0]=u*y,t[1]=(s*c-h*n)*y,t[2]=(a*n-s*o)*y,t[3]=f*y,t[4]=(h*e-s*l)*y,t[5]=(s*r-a*e)*y,t[6]=d*y,t[7]=(n*l-c*e)*y,t[8]=(o*e-n*r)*y,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return ha("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(ju.makeScale(t,e)),this}rotate(t){return ha("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(ju.makeRotation(-t)),this}translate(t,e){return ha("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(ju.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,n,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<9;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<9;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t}clone(){return new this.constructor().fromArray(this.elements)}},ju=new oe,Ym=new oe().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Zm=new oe().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function mS(){let i={enabled:!0,workingColorSpace:da,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Le&&(s.r=ws(s.r),s.g=ws(s.g),s.b=ws(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Le&&(s.r=uo(s.r),s.g=uo(s.g),s.b=uo(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Ps?pa:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[da]:{primaries:t,whitePoint:n,transfer:pa,toXYZ:Ym,fromXYZ:Zm,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:Kn},outputColorSpaceConfig:{drawingBufferColorSpace:Kn}},[Kn]:{primaries:t,whitePoint:n,transfer:Le,toXYZ:Ym,fromXYZ:Zm,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:Kn}}}),i}var Me=mS();function ws(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function uo(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var $r,Lc=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let n;if(t instanceof HTMLCanvasElement)n=t;else{$r===void 0&&($r=ma("canvas")),$r.width=t.width,$r.height=t.height;let s=$r.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),n=$r}return n.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=ma("canvas");e.width=t.width,e.height=t.height;let n=e.getContext("2d");n.drawImage(t,0,0,t.width,t.height);let s=n.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=ws(r[o]/255)*255;return n.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let n=0;n<e.length;n++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[n]=Math.floor(ws(e[n]/255)*255):e[n]=ws(e[n]);return{data:e,width:t.width,height:t.height}}else return jt("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},gS=0,_o=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:gS++}),this.uuid=nr(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Qu(s[o].image)):r.push(Qu(s[o]))}else r=Qu(s);n.url=r}return e||(t.images[this.uuid]=n),n}};function Qu(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?Lc.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(jt("Texture: Unable to serialize Texture."),{})}var _S=0,tf=new G,ei=class i extends Oi{constructor(t=i.DEFAULT_IMAGE,e=i.DEFAULT_MAPPING,n=ns,s=ns,r=Qn,o=Cs,a=Vi,l=ai,c=i.DEFAULT_ANISOTROPY,h=Ps){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:_S++}),this.uuid=nr(),this.name="",this.source=new _o(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Jt(0,0),this.repeat=new Jt(1,1),this.center=new Jt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new oe,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(tf).x}get height(){return this.source.getSize(tf).y}get depth(){return this.source.getSize(tf).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let n=t[e];if(n===void 0){jt(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){jt(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),e||(t.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==Gf)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case Rc:t.x=t.x-Math.floor(t.x);break;case ns:t.x=t.x<0?0:1;break;case Pc:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case Rc:t.y=t.y-Math.floor(t.y);break;case ns:t.y=t.y<0?0:1;break;case Pc:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};ei.DEFAULT_IMAGE=null;ei.DEFAULT_MAPPING=Gf;ei.DEFAULT_ANISOTROPY=1;var Qe=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,n=0,s=1){this.x=t,this.y=e,this.z=n,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,n,s){return this.x=t,this.y=e,this.z=n,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*n+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,n,s,r,l=t.elements,c=l[0],h=l[4],u=l[8],f=l[1],d=l[5],g=l[9],y=l[2],p=l[6],m=l[10];if(Math.abs(h-f)<.01&&Math.abs(u-y)<.01&&Math.abs(g-p)<.01){if(Math.abs(h+f)<.1&&Math.abs(u+y)<.1&&Math.abs(g+p)<.1&&Math.abs(c+d+m-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let C=(c+1)/2,b=(d+1)/2,P=(m+1)/2,A=(h+f)/4,x=(u+y)/4,T=(g+p)/4;return C>b&&C>P?C<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(C),s=A/n,r=x/n):b>P?b<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(b),n=A/s,r=T/s):P<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(P),n=x/r,s=T/r),this.set(n,s,r,e),this}let v=Math.sqrt((p-g)*(p-g)+(u-y)*(u-y)+(f-h)*(f-h));return Math.abs(v)<.001&&(v=1),this.x=(p-g)/v,this.y=(u-y)/v,this.z=(f-h)/v,this.w=Math.acos((c+d+m-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=ye(this.x,t.x,e.x),this.y=ye(this.y,t.y,e.y),this.z=ye(this.z,t.z,e.z),this.w=ye(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=ye(this.x,t,e),this.y=ye(this.y,t,e),this.z=ye(this.z,t,e),this.w=ye(this.w,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ye(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this.w=t.w+(e.w-t.w)*n,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Dc=class extends Oi{constructor(t=1,e=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Qn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=n.depth,this.scissor=new Qe(0,0,t,e),this.scissorTest=!1,this.viewport=new Qe(0,0,t,e),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new ei({width:t,height:e,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:Qn,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,n=1){if(this.width!==t||this.height!==e||this.depth!==n){this.width=t,this.height=e,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,n=t.textures.length;e<n;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new _o(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},gi=class extends Dc{constructor(t=1,e=1,n={}){super(t,e,n),this.isWebGLRenderTarget=!0}},_a=class extends ei{constructor(t=null,e=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=Un,this.minFilter=Un,this.wrapR=ns,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var Nc=class extends ei{constructor(t=null,e=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=Un,this.minFilter=Un,this.wrapR=ns,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var De=class i{static{this.prototype.isMatrix4=!0}constructor(t,e,n,s,r,o,a,l,c,h,u,f,d,g,y,p){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,l,c,h,u,f,d,g,y,p)}set(t,e,n,s,r,o,a,l,c,h,u,f,d,g,y,p){let m=this.elements;return m[0]=t,m[4]=e,m[8]=n,m[12]=s,m[1]=r,m[5]=o,m[9]=a,m[13]=l,m[2]=c,m[6]=h,m[10]=u,m[14]=f,m[3]=d,m[7]=g,m[11]=y,m[15]=p,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],e[9]=n[9],e[10]=n[10],e[11]=n[11],e[12]=n[12],e[13]=n[13],e[14]=n[14],e[15]=n[15],this}copyPosition(t){let e=this.elements,n=t.elements;return e[12]=n[12],e[13]=n[13],e[14]=n[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,n){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),n.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(t,e,n){return this.set(t.x,e.x,n.x,0,t.y,e.y,n.y,0,t.z,e.z,n.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,n=t.elements,s=1/Yr.setFromMatrixColumn(t,0).length(),r=1/Yr.setFromMatrixColumn(t,1).length(),o=1/Yr.setFromMatrixColumn(t,2).length();return e[0]=n[0]*s,e[1]=n[1]*s,e[2]=n[2]*s,e[3]=0,e[4]=n[4]*r,e[5]=n[5]*r,e[6]=n[6]*r,e[7]=0,e[8]=n[8]*o,e[9]=n[9]*o,e[10]=n[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,n=t.x,s=t.y,r=t.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(t.order==="XYZ"){let f=o*h,d=o*u,g=a*h,y=a*u;e[0]=l*h,e[4]=-l*u,e[8]=c,e[1]=d+g*c,e[5]=f-y*c,e[9]=-a*l,e[2]=y-f*c,e[6]=g+d*c,e[10]=o*l}else if(t.order==="YXZ"){let f=l*h,d=l*u,g=c*h,y=c*u;e[0]=f+y*a,e[4]=g*a-d,e[8]=o*c,e[1]=o*u,e[5]=o*h,e[9]=-a,e[2]=d*a-g,e[6]=y+f*a,e[10]=o*l}else if(t.order==="ZXY"){let f=l*h,d=l*u,g=c*h,y=c*u;e[0]=f-y*a,e[4]=-o*u,e[8]=g+d*a,e[1]=d+g*a,e[5]=o*h,e[9]=y-f*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let f=o*h,d=o*u,g=a*h,y=a*u;e[0]=l*h,e[4]=g*c-d,e[8]=f*c+y,e[1]=l*u,e[5]=y*c+f,e[9]=d*c-g,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let f=o*l,d=o*c,g=a*l,y=a*c;e[0]=l*h,e[4]=y-f*u,e[8]=g*u+d,e[1]=u,e[5]=o*h,e[9]=-a*h,e[2]=-c*h,e[6]=d*u+g,e[10]=f-y*u}else if(t.order==="XZY"){let f=o*l,d=o*c,g=a*l,y=a*c;e[0]=l*h,e[4]=-u,e[8]=c*h,e[1]=f*u+y,e[5]=o*h,e[9]=d*u-g,e[2]=g*u-d,e[6]=a*h,e[10]=y*u+f}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(xS,t,yS)}lookAt(t,e,n){let s=this.elements;return di.subVectors(t,e),di.lengthSq()===0&&(di.z=1),di.normalize(),Gs.crossVectors(n,di),Gs.lengthSq()===0&&(Math.abs(n.z)===1?di.x+=1e-4:di.z+=1e-4,di.normalize(),Gs.crossVectors(n,di)),Gs.normalize(),ql.crossVectors(di,Gs),s[0]=Gs.x,s[4]=ql.x,s[8]=di.x,s[1]=Gs.y,s[5]=ql.y,s[9]=di.y,s[2]=Gs.z,s[6]=ql.z,s[10]=di.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],h=n[1],u=n[5],f=n[9],d=n[13],g=n[2],y=n[6],p=n[10],m=n[14],v=n[3],C=n[7],b=n[11],P=n[15],A=s[0],x=s[4],T=s[8],k=s[12],U=s[1],N=s[5],z=s[9],W=s[13],D=s[2],X=s[6],Z=s[10],H=s[14],ht=s[3],j=s[7],tt=s[11],rt=s[15];return r[0]=o*A+a*U+l*D+c*ht,r[4]=o*x+a*N+l*X+c*j,r[8]=o*T+a*z+l*Z+c*tt,r[12]=o*k+a*W+l*H+c*rt,r[1]=h*A+u*U+f*D+d*ht,r[5]=h*x+u*N+f*X+d*j,r[9]=h*T+u*z+f*Z+d*tt,r[13]=h*k+u*W+f*H+d*rt,r[2]=g*A+y*U+p*D+m*ht,r[6]=g*x+y*N+p*X+m*j,r[10]=g*T+y*z+p*Z+m*tt,r[14]=g*k+y*W+p*H+m*rt,r[3]=v*A+C*U+b*D+P*ht,r[7]=v*x+C*N+b*X+P*j,r[11]=v*T+C*z+b*Z+P*tt,r[15]=v*k+C*W+b*H+P*rt,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],h=t[2],u=t[6],f=t[10],d=t[14],g=t[3],y=t[7],p=t[11],m=t[15],v=l*d-c*f,C=a*d-c*u,b=a*f-l*u,P=o*d-c*h,A=o*f-l*h,x=o*u-a*h;return e*(y*v-p*C+m*b)-n*(g*v-p*P+m*A)+s*(g*C-y*P+m*x)-r*(g*b-y*A+p*x)}determinantAffine(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[1],o=t[5],a=t[9],l=t[2],c=t[6],h=t[10];return e*(o*h-a*c)-n*(r*h-a*l)+s*(r*c-o*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,n){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=n),this}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],u=t[9],f=t[10],d=t[11],g=t[12],y=t[13],p=t[14],m=t[15],v=e*a-n*o,C=e*l-s*o,b=e*c-r*o,P=n*l-s*a,A=n*c-r*a,x=s*c-r*l,T=h*y-u*g,k=h*p-f*g,U=h*m-d*g,N=u*p-f*y,z=u*m-d*y,W=f*m-d*p,D=v*W-C*z+b*N+P*U-A*k+x*T;if(D===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let X=1/D;return t[0]=(a*W-l*z+c*N)*X,t[1]=(s*z-n*W-r*N)*X,t[2]=(y*x-p*A+m*P)*X,t[3]=(f*A-u*x-d*P)*X,t[4]=(l*U-o*W-c*k)*X,t[5]=(e*W-s*U+r*k)*X,t[6]=(p*b-g*x-m*C)*X,t[7]=(h*x-f*b+d*C)*X,t[8]=(o*z-a*U+c*T)*X,t[9]=(n*U-e*z-r*T)*X,t[10]=(g*A-y*b+m*v)*X,t[11]=(u*b-h*A-d*v)*X,t[12]=(a*k-o*N-l*T)*X,t[13]=(e*N-n*k+s*T)*X,t[14]=(y*C-g*P-p*v)*X,t[15]=(h*P-u*C+f*v)*X,this}scale(t){let e=this.elements,n=t.x,s=t.y,r=t.z;return e[0]*=n,e[4]*=s,e[8]*=r,e[1]*=n,e[5]*=s,e[9]*=r,e[2]*=n,e[6]*=s,e[10]*=r,e[3]*=n,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],n=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,n,s))}makeTranslation(t,e,n){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,n,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),n=Math.sin(t);return this.set(1,0,0,0,0,e,-n,0,0,n,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,0,n,0,0,1,0,0,-n,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,0,n,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let n=Math.cos(e),s=Math.sin(e),r=1-n,o=t.x,a=t.y,l=t.z,c=r*o,h=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+n,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(t,e,n){return this.set(t,0,0,0,0,e,0,0,0,0,n,0,0,0,0,1),this}makeShear(t,e,n,s,r,o){return this.set(1,n,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,n){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,h=o+o,u=a+a,f=r*c,d=r*h,g=r*u,y=o*h,p=o*u,m=a*u,v=l*c,C=l*h,b=l*u,P=n.x,A=n.y,x=n.z;return s[0]=(1-(y+m))*P,s[1]=(d+b)*P,s[2]=(g-C)*P,s[3]=0,s[4]=(d-b)*A,s[5]=(1-(f+m))*A,s[6]=(p+v)*A,s[7]=0,s[8]=(g+C)*x,s[9]=(p-v)*x,s[10]=(1-(f+y))*x,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,n){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),e.identity(),this;let o=Yr.set(s[0],s[1],s[2]).length(),a=Yr.set(s[4],s[5],s[6]).length(),l=Yr.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Di.copy(this);let c=1/o,h=1/a,u=1/l;return Di.elements[0]*=c,Di.elements[1]*=c,Di.elements[2]*=c,Di.elements[4]*=h,Di.elements[5]*=h,Di.elements[6]*=h,Di.elements[8]*=u,Di.elements[9]*=u,Di.elements[10]*=u,e.setFromRotationMatrix(Di),n.x=o,n.y=a,n.z=l,this}makePerspective(t,e,n,s,r,o,a=Ti,l=!1){let c=this.elements,h=2*r/(e-t),u=2*r/(n-s),f=(e+t)/(e-t),d=(n+s)/(n-s),g,y;if(l)g=r/(o-r),y=o*r/(o-r);else if(a===Ti)g=-(o+r)/(o-r),y=-2*o*r/(o-r);else if(a===po)g=-o/(o-r),y=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=f,c[12]=0,c[1]=0,c[5]=u,c[9]=d,c[13]=0,c[2]=0,c[6]=0,c[10]=g,c[14]=y,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,n,s,r,o,a=Ti,l=!1){let c=this.elements,h=2/(e-t),u=2/(n-s),f=-(e+t)/(e-t),d=-(n+s)/(n-s),g,y;if(l)g=1/(o-r),y=o/(o-r);else if(a===Ti)g=-2/(o-r),y=-(o+r)/(o-r);else if(a===po)g=-1/(o-r),y=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=f,c[1]=0,c[5]=u,c[9]=0,c[13]=d,c[2]=0,c[6]=0,c[10]=g,c[14]=y,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<16;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<16;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t[e+9]=n[9],t[e+10]=n[10],t[e+11]=n[11],t[e+12]=n[12],t[e+13]=n[13],t[e+14]=n[14],t[e+15]=n[15],t}},Yr=new G,Di=new De,xS=new G(0,0,0),yS=new G(1,1,1),Gs=new G,ql=new G,di=new G,Jm=new De,Km=new ti,Es=class i{constructor(t=0,e=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=n,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,n,s=this._order){return this._x=t,this._y=e,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,n=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],u=s[2],f=s[6],d=s[10];switch(e){case"XYZ":this._y=Math.asin(ye(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,d),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-ye(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,d),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(ye(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-u,d),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-ye(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(f,d),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(ye(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(a,d));break;case"XZY":this._z=Math.asin(-ye(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,d),this._y=0);break;default:jt("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,n===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,n){return Jm.makeRotationFromQuaternion(t),this.setFromRotationMatrix(Jm,e,n)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return Km.setFromEuler(this),this.setFromQuaternion(Km,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Es.DEFAULT_ORDER="XYZ";var xa=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},vS=0,jm=new G,Zr=new ti,ys=new De,$l=new G,na=new G,SS=new G,MS=new ti,Qm=new G(1,0,0),tg=new G(0,1,0),eg=new G(0,0,1),ng={type:"added"},bS={type:"removed"},Jr={type:"childadded",child:null},ef={type:"childremoved",child:null},Fn=class i extends Oi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:vS++}),this.uuid=nr(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let t=new G,e=new Es,n=new ti,s=new G(1,1,1);function r(){n.setFromEuler(e,!1)}function o(){e.setFromQuaternion(n,void 0,!1)}e._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new De},normalMatrix:{value:new oe}}),this.matrix=new De,this.matrixWorld=new De,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new xa,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return Zr.setFromAxisAngle(t,e),this.quaternion.multiply(Zr),this}rotateOnWorldAxis(t,e){return Zr.setFromAxisAngle(t,e),this.quaternion.premultiply(Zr),this}rotateX(t){return this.rotateOnAxis(Qm,t)}rotateY(t){return this.rotateOnAxis(tg,t)}rotateZ(t){return this.rotateOnAxis(eg,t)}translateOnAxis(t,e){return jm.copy(t).applyQuaternion(this.quaternion),this.position.add(jm.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(Qm,t)}translateY(t){return this.translateOnAxis(tg,t)}translateZ(t){return this.translateOnAxis(eg,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(ys.copy(this.matrixWorld).invert())}lookAt(t,e,n){t.isVector3?$l.copy(t):$l.set(t,e,n);let s=this.parent;this.updateWorldMatrix(!0,!1),na.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?ys.lookAt(na,$l,this.up):ys.lookAt($l,na,this.up),this.quaternion.setFromRotationMatrix(ys),s&&(ys.extractRotation(s.matrixWorld),Zr.setFromRotationMatrix(ys),this.quaternion.premultiply(Zr.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(se("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(ng),Jr.child=t,this.dispatchEvent(Jr),Jr.child=null):se("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(bS),ef.child=t,this.dispatchEvent(ef),ef.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),ys.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),ys.multiply(t.parent.matrixWorld)),t.applyMatrix4(ys),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(ng),Jr.child=t,this.dispatchEvent(Jr),Jr.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,n=[]){this[t]===e&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,n);return n}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(na,t,SS),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(na,MS,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,n=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*n-r[8]*s,r[13]+=n-r[1]*e-r[5]*n-r[9]*s,r[14]+=s-r[2]*e-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].updateMatrixWorld(t)}updateWorldMatrix(t,e,n=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,n)}}toJSON(t){let e=t===void 0||typeof t=="string",n={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let u=l[c];r(t.shapes,u)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),h=o(t.images),u=o(t.shapes),f=o(t.skeletons),d=o(t.animations),g=o(t.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),u.length>0&&(n.shapes=u),f.length>0&&(n.skeletons=f),d.length>0&&(n.animations=d),g.length>0&&(n.nodes=g)}return n.object=s,n;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let n=0;n<t.children.length;n++){let s=t.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Fn.DEFAULT_UP=new G(0,1,0);Fn.DEFAULT_MATRIX_AUTO_UPDATE=!0;Fn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var kn=class extends Fn{constructor(){super(),this.isGroup=!0,this.type="Group"}},wS={type:"move"},xo=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new kn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new kn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new G,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new G),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new kn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new G,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new G,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let n of t.hand.values())this._getHandJoint(e,n)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,n){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let y of t.hand.values()){let p=e.getJointPose(y,n),m=this._getHandJoint(c,y);p!==null&&(m.matrix.fromArray(p.transform.matrix),m.matrix.decompose(m.position,m.quaternion,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=p.radius),m.visible=p!==null}let h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],f=h.position.distanceTo(u.position),d=.02,g=.005;c.inputState.pinching&&f>d+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&f<=d-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(wS)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let n=new kn;n.matrixAutoUpdate=!1,n.visible=!1,t.joints[e.jointName]=n,t.add(n)}return t.joints[e.jointName]}},s0={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Hs={h:0,s:0,l:0},Yl={h:0,s:0,l:0};function nf(i,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?i+(t-i)*6*e:e<1/2?t:e<2/3?i+(t-i)*6*(2/3-e):i}var ue=class{constructor(t,e,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,n)}set(t,e,n){if(e===void 0&&n===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,n);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=Kn){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,Me.colorSpaceToWorking(this,e),this}setRGB(t,e,n,s=Me.workingColorSpace){return this.r=t,this.g=e,this.b=n,Me.colorSpaceToWorking(this,s),this}setHSL(t,e,n,s=Me.workingColorSpace){if(t=ed(t,1),e=ye(e,0,1),n=ye(n,0,1),e===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+e):n+e-n*e,o=2*n-r;this.r=nf(o,r,t+1/3),this.g=nf(o,r,t),this.b=nf(o,r,t-1/3)}return Me.colorSpaceToWorking(this,s),this}setStyle(t,e=Kn){function n(r){r!==void 0&&parseFloat(r)<1&&jt("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:jt("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);jt("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=Kn){let n=s0[t.toLowerCase()];return n!==void 0?this.setHex(n,e):jt("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=ws(t.r),this.g=ws(t.g),this.b=ws(t.b),this}copyLinearToSRGB(t){return this.r=uo(t.r),this.g=uo(t.g),this.b=uo(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=Kn){return Me.workingToColorSpace(Hn.copy(this),t),Math.round(ye(Hn.r*255,0,255))*65536+Math.round(ye(Hn.g*255,0,255))*256+Math.round(ye(Hn.b*255,0,255))}getHexString(t=Kn){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=Me.workingColorSpace){Me.workingToColorSpace(Hn.copy(this),e);let n=Hn.r,s=Hn.g,r=Hn.b,o=Math.max(n,s,r),a=Math.min(n,s,r),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let u=o-a;switch(c=h<=.5?u/(o+a):u/(2-o-a),o){case n:l=(s-r)/u+(s<r?6:0);break;case s:l=(r-n)/u+2;break;case r:l=(n-s)/u+4;break}l/=6}return t.h=l,t.s=c,t.l=h,t}getRGB(t,e=Me.workingColorSpace){return Me.workingToColorSpace(Hn.copy(this),e),t.r=Hn.r,t.g=Hn.g,t.b=Hn.b,t}getStyle(t=Kn){Me.workingToColorSpace(Hn.copy(this),t);let e=Hn.r,n=Hn.g,s=Hn.b;return t!==Kn?`color(${t} ${e.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(t,e,n){return this.getHSL(Hs),this.setHSL(Hs.h+t,Hs.s+e,Hs.l+n)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,n){return this.r=t.r+(e.r-t.r)*n,this.g=t.g+(e.g-t.g)*n,this.b=t.b+(e.b-t.b)*n,this}lerpHSL(t,e){this.getHSL(Hs),t.getHSL(Yl);let n=ua(Hs.h,Yl.h,e),s=ua(Hs.s,Yl.s,e),r=ua(Hs.l,Yl.l,e);return this.setHSL(n,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,n=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*n+r[6]*s,this.g=r[1]*e+r[4]*n+r[7]*s,this.b=r[2]*e+r[5]*n+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Hn=new ue;ue.NAMES=s0;var ya=class extends Fn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Es,this.environmentIntensity=1,this.environmentRotation=new Es,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},Ni=new G,vs=new G,sf=new G,Ss=new G,Kr=new G,jr=new G,ig=new G,rf=new G,of=new G,af=new G,lf=new Qe,cf=new Qe,hf=new Qe,es=class i{constructor(t=new G,e=new G,n=new G){this.a=t,this.b=e,this.c=n}static getNormal(t,e,n,s){s.subVectors(n,e),Ni.subVectors(t,e),s.cross(Ni);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,n,s,r){Ni.subVectors(s,e),vs.subVectors(n,e),sf.subVectors(t,e);let o=Ni.dot(Ni),a=Ni.dot(vs),l=Ni.dot(sf),c=vs.dot(vs),h=vs.dot(sf),u=o*c-a*a;if(u===0)return r.set(0,0,0),null;let f=1/u,d=(c*l-a*h)*f,g=(o*h-a*l)*f;return r.set(1-d-g,g,d)}static containsPoint(t,e,n,s){return this.getBarycoord(t,e,n,s,Ss)===null?!1:Ss.x>=0&&Ss.y>=0&&Ss.x+Ss.y<=1}static getInterpolation(t,e,n,s,r,o,a,l){return this.getBarycoord(t,e,n,s,Ss)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Ss.x),l.addScaledVector(o,Ss.y),l.addScaledVector(a,Ss.z),l)}static getInterpolatedAttribute(t,e,n,s,r,o){return lf.setScalar(0),cf.setScalar(0),hf.setScalar(0),lf.fromBufferAttribute(t,e),cf.fromBufferAttribute(t,n),hf.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(lf,r.x),o.addScaledVector(cf,r.y),o.addScaledVector(hf,r.z),o}static isFrontFacing(t,e,n,s){return Ni.subVectors(n,e),vs.subVectors(t,e),Ni.cross(vs).dot(s)<0}set(t,e,n){return this.a.copy(t),this.b.copy(e),this.c.copy(n),this}setFromPointsAndIndices(t,e,n,s){return this.a.copy(t[e]),this.b.copy(t[n]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,n,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,n),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return Ni.subVectors(this.c,this.b),vs.subVectors(this.a,this.b),Ni.cross(vs).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return i.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return i.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,n,s,r){return i.getInterpolation(t,this.a,this.b,this.c,e,n,s,r)}containsPoint(t){return i.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return i.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let n=this.a,s=this.b,r=this.c,o,a;Kr.subVectors(s,n),jr.subVectors(r,n),rf.subVectors(t,n);let l=Kr.dot(rf),c=jr.dot(rf);if(l<=0&&c<=0)return e.copy(n);of.subVectors(t,s);let h=Kr.dot(of),u=jr.dot(of);if(h>=0&&u<=h)return e.copy(s);let f=l*u-h*c;if(f<=0&&l>=0&&h<=0&&l-h>0)return o=l/(l-h),e.copy(n).addScaledVector(Kr,o);af.subVectors(t,r);let d=Kr.dot(af),g=jr.dot(af);if(g>=0&&d<=g)return e.copy(r);let y=d*c-l*g;if(y<=0&&c>=0&&g<=0)return a=c/(c-g),e.copy(n).addScaledVector(jr,a);let p=h*g-d*u;if(p<=0&&u-h>=0&&d-g>=0)return ig.subVectors(r,s),a=(u-h)/(u-h+(d-g)),e.copy(s).addScaledVector(ig,a);let m=1/(p+y+f);return o=y*m,a=f*m,e.copy(n).addScaledVector(Kr,o).addScaledVector(jr,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},$s=class{constructor(t=new G(1/0,1/0,1/0),e=new G(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e+=3)this.expandByPoint(Ui.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,n=t.count;e<n;e++)this.expandByPoint(Ui.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let n=Ui.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(n),this.max.copy(t).add(n),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let n=t.geometry;if(n!==void 0){let r=n.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Ui):Ui.fromBufferAttribute(r,o),Ui.applyMatrix4(t.matrixWorld),this.expandByPoint(Ui);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),Zl.copy(t.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),Zl.copy(n.boundingBox)),Zl.applyMatrix4(t.matrixWorld),this.union(Zl)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Ui),Ui.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,n;return t.normal.x>0?(e=t.normal.x*this.min.x,n=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,n=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,n+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,n+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,n+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,n+=t.normal.z*this.min.z),e<=-t.constant&&n>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(ia),Jl.subVectors(this.max,ia),Qr.subVectors(t.a,ia),to.subVectors(t.b,ia),eo.subVectors(t.c,ia),Ws.subVectors(to,Qr),Xs.subVectors(eo,to),ur.subVectors(Qr,eo);let e=[0,-Ws.z,Ws.y,0,-Xs.z,Xs.y,0,-ur.z,ur.y,Ws.z,0,-Ws.x,Xs.z,0,-Xs.x,ur.z,0,-ur.x,-Ws.y,Ws.x,0,-Xs.y,Xs.x,0,-ur.y,ur.x,0];return!uf(e,Qr,to,eo,Jl)||(e=[1,0,0,0,1,0,0,0,1],!uf(e,Qr,to,eo,Jl))?!1:(Kl.crossVectors(Ws,Xs),e=[Kl.x,Kl.y,Kl.z],uf(e,Qr,to,eo,Jl))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Ui).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Ui).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(Ms[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),Ms[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),Ms[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),Ms[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),Ms[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),Ms[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),Ms[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),Ms[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(Ms),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},Ms=[new G,new G,new G,new G,new G,new G,new G,new G],Ui=new G,Zl=new $s,Qr=new G,to=new G,eo=new G,Ws=new G,Xs=new G,ur=new G,ia=new G,Jl=new G,Kl=new G,fr=new G;function uf(i,t,e,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){fr.fromArray(i,r);let a=s.x*Math.abs(fr.x)+s.y*Math.abs(fr.y)+s.z*Math.abs(fr.z),l=t.dot(fr),c=e.dot(fr),h=n.dot(fr);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var _n=new G,jl=new Jt,TS=0,Fi=class extends Oi{constructor(t,e,n=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:TS++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=n,this.usage=Qf,this.updateRanges=[],this.gpuType=ki,this.version=0,this._normalizationScale=t!==void 0?Vh(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,n){t*=this.itemSize,n*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[n+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,n=this.count;e<n;e++)jl.fromBufferAttribute(this,e),jl.applyMatrix3(t),this.setXY(e,jl.x,jl.y);else if(this.itemSize===3)for(let e=0,n=this.count;e<n;e++)_n.fromBufferAttribute(this,e),_n.applyMatrix3(t),this.setXYZ(e,_n.x,_n.y,_n.z);return this}applyMatrix4(t){for(let e=0,n=this.count;e<n;e++)_n.fromBufferAttribute(this,e),_n.applyMatrix4(t),this.setXYZ(e,_n.x,_n.y,_n.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)_n.fromBufferAttribute(this,e),_n.applyNormalMatrix(t),this.setXYZ(e,_n.x,_n.y,_n.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)_n.fromBufferAttribute(this,e),_n.transformDirection(t),this.setXYZ(e,_n.x,_n.y,_n.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let n=this.array[t*this.itemSize+e];return this.normalized&&(n=this._denormalize(n)),n}setComponent(t,e,n){return this.normalized&&(n=this._normalize(n)),this.array[t*this.itemSize+e]=n,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,n){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n)),this.array[t+0]=e,this.array[t+1]=n,this}setXYZ(t,e,n,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this}setXYZW(t,e,n,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):id(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):sd(t,this.array)}};var va=class extends Fi{constructor(t,e,n){super(new Uint16Array(t),e,n)}};var Sa=class extends Fi{constructor(t,e,n){super(new Uint32Array(t),e,n)}};var Re=class extends Fi{constructor(t,e,n){super(new Float32Array(t),e,n)}},ES=new $s,sa=new G,ff=new G,mr=class{constructor(t=new G,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let n=this.center;e!==void 0?n.copy(e):ES.setFromPoints(t).getCenter(n);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,n.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let n=this.center.distanceToSquared(t);return e.copy(t),n>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;sa.subVectors(t,this.center);let e=sa.lengthSq();if(e>this.radius*this.radius){let n=Math.sqrt(e),s=(n-this.radius)*.5;this.center.addScaledVector(sa,s/n),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(ff.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(sa.copy(t.center).add(ff)),this.expandByPoint(sa.copy(t.center).sub(ff))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},AS=0,wi=new De,df=new Fn,no=new G,pi=new $s,ra=new $s,Nn=new G,an=class i extends Oi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:AS++}),this.uuid=nr(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(jv(t)?Sa:va)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,n=0){this.groups.push({start:t,count:e,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new oe().getNormalMatrix(t);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return wi.makeRotationFromQuaternion(t),this.applyMatrix4(wi),this}rotateX(t){return wi.makeRotationX(t),this.applyMatrix4(wi),this}rotateY(t){return wi.makeRotationY(t),this.applyMatrix4(wi),this}rotateZ(t){return wi.makeRotationZ(t),this.applyMatrix4(wi),this}translate(t,e,n){return wi.makeTranslation(t,e,n),this.applyMatrix4(wi),this}scale(t,e,n){return wi.makeScale(t,e,n),this.applyMatrix4(wi),this}lookAt(t){return df.lookAt(t),df.updateMatrix(),this.applyMatrix4(df.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(no).negate(),this.translate(no.x,no.y,no.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let n=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Re(n,3))}else{let n=Math.min(t.length,e.count);for(let s=0;s<n;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&jt("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new $s);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){se("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new G(-1/0,-1/0,-1/0),new G(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let n=0,s=e.length;n<s;n++){let r=e[n];pi.setFromBufferAttribute(r),this.morphTargetsRelative?(Nn.addVectors(this.boundingBox.min,pi.min),this.boundingBox.expandByPoint(Nn),Nn.addVectors(this.boundingBox.max,pi.max),this.boundingBox.expandByPoint(Nn)):(this.boundingBox.expandByPoint(pi.min),this.boundingBox.expandByPoint(pi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&se('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new mr);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){se("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new G,1/0);return}if(t){let n=this.boundingSphere.center;if(pi.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];ra.setFromBufferAttribute(a),this.morphTargetsRelative?(Nn.addVectors(pi.min,ra.min),pi.expandByPoint(Nn),Nn.addVectors(pi.max,ra.max),pi.expandByPoint(Nn)):(pi.expandByPoint(ra.min),pi.expandByPoint(ra.max))}pi.getCenter(n);let s=0;for(let r=0,o=t.count;r<o;r++)Nn.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(Nn));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)Nn.fromBufferAttribute(a,c),l&&(no.fromBufferAttribute(t,c),Nn.add(no)),s=Math.max(s,n.distanceToSquared(Nn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&se('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){se("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new Fi(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(n.count);for(let k=0;k<n.count;k++)a[k]=new G,l[k]=new G;let h=new G,u=new G,f=new G,d=new Jt,g=new Jt,y=new Jt,p=new G,m=new G;function v(k,U,N){c[k]=c[U]=c[N]=1,h.fromBufferAttribute(n,k),u.fromBufferAttribute(n,U),f.fromBufferAttribute(n,N),d.fromBufferAttribute(r,k),g.fromBufferAttribute(r,U),y.fromBufferAttribute(r,N),u.sub(h),f.sub(h),g.sub(d),y.sub(d);let z=1/(g.x*y.y-y.x*g.y);isFinite(z)&&(p.copy(u).multiplyScalar(y.y).addScaledVector(f,-g.y).multiplyScalar(z),m.copy(f).multiplyScalar(g.x).addScaledVector(u,-y.x).multiplyScalar(z),a[k].add(p),a[U].add(p),a[N].add(p),l[k].add(m),l[U].add(m),l[N].add(m))}let C=this.groups;C.length===0&&(C=[{start:0,count:t.count}]);for(let k=0,U=C.length;k<U;++k){let N=C[k],z=N.start,W=N.count;for(let D=z,X=z+W;D<X;D+=3)v(t.getX(D+0),t.getX(D+1),t.getX(D+2))}let b=new G,P=new G,A=new G,x=new G;function T(k){A.fromBufferAttribute(s,k),x.copy(A);let U=a[k];b.copy(U),b.sub(A.multiplyScalar(A.dot(U))).normalize(),P.crossVectors(x,U);let z=P.dot(l[k])<0?-1:1;o.setXYZW(k,b.x,b.y,b.z,z)}for(let k=0,U=n.count;k<U;++k)c[k]&&T(k);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==e.count)n=new Fi(new Float32Array(e.count*3),3),this.setAttribute("normal",n);else for(let f=0,d=n.count;f<d;f++)n.setXYZ(f,0,0,0);let s=new G,r=new G,o=new G,a=new G,l=new G,c=new G,h=new G,u=new G;if(t)for(let f=0,d=t.count;f<d;f+=3){let g=t.getX(f+0),y=t.getX(f+1),p=t.getX(f+2);s.fromBufferAttribute(e,g),r.fromBufferAttribute(e,y),o.fromBufferAttribute(e,p),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),a.fromBufferAttribute(n,g),l.fromBufferAttribute(n,y),c.fromBufferAttribute(n,p),a.add(h),l.add(h),c.add(h),n.setXYZ(g,a.x,a.y,a.z),n.setXYZ(y,l.x,l.y,l.z),n.setXYZ(p,c.x,c.y,c.z)}else for(let f=0,d=e.count;f<d;f+=3)s.fromBufferAttribute(e,f+0),r.fromBufferAttribute(e,f+1),o.fromBufferAttribute(e,f+2),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),n.setXYZ(f+0,h.x,h.y,h.z),n.setXYZ(f+1,h.x,h.y,h.z),n.setXYZ(f+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,n=t.count;e<n;e++)Nn.fromBufferAttribute(t,e),Nn.normalize(),t.setXYZ(e,Nn.x,Nn.y,Nn.z)}toNonIndexed(){function t(a,l){let c=a.array,h=a.itemSize,u=a.normalized,f=new c.constructor(l.length*h),d=0,g=0;for(let y=0,p=l.length;y<p;y++){a.isInterleavedBufferAttribute?d=l[y]*a.data.stride+a.offset:d=l[y]*h;for(let m=0;m<h;m++)f[g++]=c[d++]}return new Fi(f,h,u)}if(this.index===null)return jt("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new i,n=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,n);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let h=0,u=c.length;h<u;h++){let f=c[h],d=t(f,n);l.push(d)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let n=this.attributes;for(let l in n){let c=n[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let u=0,f=c.length;u<f;u++){let d=c[u];h.push(d.toJSON(t.data))}h.length>0&&(s[l]=h,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let n=t.index;n!==null&&this.setIndex(n.clone());let s=t.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(e))}let r=t.morphAttributes;for(let c in r){let h=[],u=r[c];for(let f=0,d=u.length;f<d;f++)h.push(u[f].clone(e));this.morphAttributes[c]=h}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,h=o.length;c<h;c++){let u=o[c];this.addGroup(u.start,u.count,u.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},Uc=class{constructor(t,e){this.isInterleavedBuffer=!0,this.array=t,this.stride=e,this.count=t!==void 0?t.length/e:0,this.usage=Qf,this.updateRanges=[],this.version=0,this.uuid=nr()}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.array=new t.array.constructor(t.array),this.count=t.count,this.stride=t.stride,this.usage=t.usage,this}copyAt(t,e,n){t*=this.stride,n*=e.stride;for(let s=0,r=this.stride;s<r;s++)this.array[t+s]=e.array[n+s];return this}set(t,e=0){return this.array.set(t,e),this}clone(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=sg(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=this.array.slice(0).buffer);let n=new this.array.constructor(t.arrayBuffers[e]),s=new this.constructor(n,this.stride);return s.setUsage(this.usage),s}onUpload(t){return this.onUploadCallback=t,this}toJSON(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=sg(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let n={uuid:this.uuid,buffer:e,type:this.array.constructor.name,stride:this.stride};return n.usage=this.usage,n}};function sg(i){return i.buffer._uuid===void 0&&(i.buffer._uuid=nr()),i.byteOffset===0&&i.byteLength===i.buffer.byteLength?i.buffer._uuid:i.buffer._uuid+":"+i.byteOffset+":"+i.byteLength}var Jn=new G,Ma=class i{constructor(t,e,n,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=t,this.itemSize=e,this.offset=n,this.normalized=s,this._normalizationScale=t!==void 0?Vh(t.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(t){this.data.needsUpdate=t}applyMatrix4(t){for(let e=0,n=this.data.count;e<n;e++)Jn.fromBufferAttribute(this,e),Jn.applyMatrix4(t),this.setXYZ(e,Jn.x,Jn.y,Jn.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)Jn.fromBufferAttribute(this,e),Jn.applyNormalMatrix(t),this.setXYZ(e,Jn.x,Jn.y,Jn.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)Jn.fromBufferAttribute(this,e),Jn.transformDirection(t),this.setXYZ(e,Jn.x,Jn.y,Jn.z);return this}getComponent(t,e){let n=this.array[t*this.data.stride+this.offset+e];return this.normalized&&(n=this._denormalize(n)),n}setComponent(t,e,n){return this.normalized&&(n=this._normalize(n)),this.data.array[t*this.data.stride+this.offset+e]=n,this}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset]=e,this}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+1]=e,this}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+2]=e,this}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+3]=e,this}getX(t){let e=this.data.array[t*this.data.stride+this.offset];return this.normalized&&(e=this._denormalize(e)),e}getY(t){let e=this.data.array[t*this.data.stride+this.offset+1];return this.normalized&&(e=this._denormalize(e)),e}getZ(t){let e=this.data.array[t*this.data.stride+this.offset+2];return this.normalized&&(e=this._denormalize(e)),e}getW(t){let e=this.data.array[t*this.data.stride+this.offset+3];return this.normalized&&(e=this._denormalize(e)),e}setXY(t,e,n){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),n=this._normalize(n)),this.data.array[t+0]=e,this.data.array[t+1]=n,this}setXYZ(t,e,n,s){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s)),this.data.array[t+0]=e,this.data.array[t+1]=n,this.data.array[t+2]=s,this}setXYZW(t,e,n,s,r){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.data.array[t+0]=e,this.data.array[t+1]=n,this.data.array[t+2]=s,this.data.array[t+3]=r,this}clone(t){if(t===void 0){ga("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return new Fi(new this.array.constructor(e),this.itemSize,this.normalized)}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.clone(t)),new i(t.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(t){if(t===void 0){ga("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:e,normalized:this.normalized}}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.toJSON(t)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):id(t,this.data.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):sd(t,this.data.array)}},pf=new G,CS=new G,RS=new oe,mi=class{constructor(t=new G(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,n,s){return this.normal.set(t,e,n),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,n){let s=pf.subVectors(n,e).cross(CS.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,n=!0){let s=t.delta(pf),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return n===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),n=this.distanceToPoint(t.end);return e<0&&n>0||n<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let n=e||RS.getNormalMatrix(t),s=this.coplanarPoint(pf).applyMatrix4(t),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},PS=0,is=class extends Oi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:PS++}),this.uuid=nr(),this.name="",this.type="Material",this.blending=To,this.side=tr,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Lf,this.blendDst=Df,this.blendEquation=vr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new ue(0,0,0),this.blendAlpha=0,this.depthFunc=fo,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Yg,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Sc,this.stencilZFail=Sc,this.stencilZPass=Sc,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let n=t[e];if(n===void 0){jt(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){jt(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(t).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(t).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(t).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(t).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(t).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new ue().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(n=>new mi().fromJSON(n))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let n=t.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new Jt().fromArray(n)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Jt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,n=null;if(e!==null){let s=e.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=e[r].clone()}return this.clippingPlanes=n,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}},yo=class extends is{constructor(t){super(),this.isSpriteMaterial=!0,this.type="SpriteMaterial",this.color=new ue(16777215),this.map=null,this.alphaMap=null,this.rotation=0,this.sizeAttenuation=!0,this.transparent=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.rotation=t.rotation,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},io,oa=new G,so=new G,ro=new G,oo=new Jt,aa=new Jt,r0=new De,Ql=new G,la=new G,tc=new G,rg=new Jt,mf=new Jt,og=new Jt,ba=class extends Fn{constructor(t=new yo){if(super(),this.isSprite=!0,this.type="Sprite",io===void 0){io=new an;let e=new Float32Array([-.5,-.5,0,0,0,.5,-.5,0,1,0,.5,.5,0,1,1,-.5,.5,0,0,1]),n=new Uc(e,5);io.setIndex([0,1,2,0,2,3]),io.setAttribute("position",new Ma(n,3,0,!1)),io.setAttribute("uv",new Ma(n,2,3,!1))}this.geometry=io,this.material=t,this.center=new Jt(.5,.5),this.count=1}intersectsFrustum(t){return t.intersectsSprite(this)}raycast(t,e){t.camera===null&&se('Sprite: "Raycaster.camera" needs to be set in order to raycast against sprites.'),so.setFromMatrixScale(this.matrixWorld),r0.copy(t.camera.matrixWorld),this.modelViewMatrix.multiplyMatrices(t.camera.matrixWorldInverse,this.matrixWorld),ro.setFromMatrixPosition(this.modelViewMatrix),t.camera.isPerspectiveCamera&&this.material.sizeAttenuation===!1&&so.multiplyScalar(-ro.z);let n=this.material.rotation,s,r;n!==0&&(r=Math.cos(n),s=Math.sin(n));let o=this.center;ec(Ql.set(-.5,-.5,0),ro,o,so,s,r),ec(la.set(.5,-.5,0),ro,o,so,s,r),ec(tc.set(.5,.5,0),ro,o,so,s,r),rg.set(0,0),mf.set(1,0),og.set(1,1);let a=t.ray.intersectTriangle(Ql,la,tc,!1,oa);if(a===null&&(ec(la.set(-.5,.5,0),ro,o,so,s,r),mf.set(0,1),a=t.ray.intersectTriangle(Ql,tc,la,!1,oa),a===null))return;let l=t.ray.origin.distanceTo(oa);l<t.near||l>t.far||e.push({distance:l,point:oa.clone(),uv:es.getInterpolation(oa,Ql,la,tc,rg,mf,og,new Jt),face:null,object:this})}copy(t,e){return super.copy(t,e),t.center!==void 0&&this.center.copy(t.center),this.material=t.material,this}toJSON(t){let e=super.toJSON(t);return e.object.center=this.center.toArray(),e}};function ec(i,t,e,n,s,r){oo.subVectors(i,e).addScalar(.5).multiply(n),s!==void 0?(aa.x=r*oo.x-s*oo.y,aa.y=s*oo.x+r*oo.y):aa.copy(oo),i.copy(t),i.x+=aa.x,i.y+=aa.y,i.applyMatrix4(r0)}var bs=new G,gf=new G,nc=new G,ic=new G,gr=class{constructor(t=new G,e=new G(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,bs)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let n=e.dot(this.direction);return n<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=bs.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(bs.copy(this.origin).addScaledVector(this.direction,e),bs.distanceToSquared(t))}distanceSqToSegment(t,e,n,s){gf.copy(t).add(e).multiplyScalar(.5),nc.copy(e).sub(t).normalize(),ic.copy(this.origin).sub(gf);let r=t.distanceTo(e)*.5,o=-this.direction.dot(nc),a=ic.dot(this.direction),l=-ic.dot(nc),c=ic.lengthSq(),h=Math.abs(1-o*o),u,f,d,g;if(h>0)if(u=o*l-a,f=o*a-l,g=r*h,u>=0)if(f>=-g)if(f<=g){let y=1/h;u*=y,f*=y,d=u*(u+o*f+2*a)+f*(o*u+f+2*l)+c}else f=r,u=Math.max(0,-(o*f+a)),d=-u*u+f*(f+2*l)+c;else f=-r,u=Math.max(0,-(o*f+a)),d=-u*u+f*(f+2*l)+c;else f<=-g?(u=Math.max(0,-(-o*r+a)),f=u>0?-r:Math.min(Math.max(-r,-l),r),d=-u*u+f*(f+2*l)+c):f<=g?(u=0,f=Math.min(Math.max(-r,-l),r),d=f*(f+2*l)+c):(u=Math.max(0,-(o*r+a)),f=u>0?r:Math.min(Math.max(-r,-l),r),d=-u*u+f*(f+2*l)+c);else f=o>0?-r:r,u=Math.max(0,-(o*f+a)),d=-u*u+f*(f+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(gf).addScaledVector(nc,f),d}intersectSphere(t,e){if(t.radius<0)return null;bs.subVectors(t.center,this.origin);let n=bs.dot(this.direction),s=bs.dot(bs)-n*n,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(t.normal)+t.constant)/e;return n>=0?n:null}intersectPlane(t,e){let n=this.distanceToPlane(t);return n===null?null:this.at(n,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let n,s,r,o,a,l,c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,f=this.origin;return c>=0?(n=(t.min.x-f.x)*c,s=(t.max.x-f.x)*c):(n=(t.max.x-f.x)*c,s=(t.min.x-f.x)*c),h>=0?(r=(t.min.y-f.y)*h,o=(t.max.y-f.y)*h):(r=(t.max.y-f.y)*h,o=(t.min.y-f.y)*h),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),u>=0?(a=(t.min.z-f.z)*u,l=(t.max.z-f.z)*u):(a=(t.max.z-f.z)*u,l=(t.min.z-f.z)*u),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,e)}intersectsBox(t){return this.intersectBox(t,bs)!==null}intersectTriangle(t,e,n,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,h=a.z,u=t.x-o.x,f=t.y-o.y,d=t.z-o.z,g=e.x-o.x,y=e.y-o.y,p=e.z-o.z,m=n.x-o.x,v=n.y-o.y,C=n.z-o.z,b=Math.abs(l),P=Math.abs(c),A=Math.abs(h),x,T,k,U,N,z,W,D,X,Z,H,ht;if(b>=P&&b>=A?(k=l,z=u,X=g,ht=m,l>=0?(x=c,T=h,U=f,N=d,W=y,D=p,Z=v,H=C):(x=h,T=c,U=d,N=f,W=p,D=y,Z=C,H=v)):P>=A?(k=c,z=f,X=y,ht=v,c>=0?(x=h,T=l,U=d,N=u,W=p,D=g,Z=C,H=m):(x=l,T=h,U=u,N=d,W=g,D=p,Z=m,H=C)):(k=h,z=d,X=p,ht=C,h>=0?(x=l,T=c,U=u,N=f,W=g,D=y,Z=m,H=v):(x=c,T=l,U=f,N=u,W=y,D=g,Z=v,H=m)),k===0)return null;let j=x/k,tt=T/k,rt=1/k,pt=U-j*z,dt=N-tt*z,et=W-j*X,xt=D-tt*X,St=Z-j*ht,Pt=H-tt*ht,Tt=St*xt-Pt*et,Yt=pt*Pt-dt*St,ce=et*dt-xt*pt;if(s){if(Tt<0||Yt<0||ce<0)return null}else if((Tt<0||Yt<0||ce<0)&&(Tt>0||Yt>0||ce>0))return null;let qt=Tt+Yt+ce;if(qt===0)return null;let ge=rt*(Tt*z+Yt*X+ce*ht);return(qt>0?ge<0:ge>0)?null:this.at(ge/qt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},ss=class extends is{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new ue(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Es,this.combine=Nf,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},ag=new De,dr=new gr,sc=new mr,lg=new G,rc=new G,oc=new G,ac=new G,_f=new G,lc=new G,cg=new G,cc=new G,bn=class extends Fn{constructor(t=new an,e=new ss){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){lc.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=a[l],u=r[l];h!==0&&(_f.fromBufferAttribute(u,t),o?lc.addScaledVector(_f,h):lc.addScaledVector(_f.sub(e),h))}e.add(lc)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),sc.copy(n.boundingSphere),sc.applyMatrix4(r),dr.copy(t.ray).recast(t.near),!(sc.containsPoint(dr.origin)===!1&&(dr.intersectSphere(sc,lg)===null||dr.origin.distanceToSquared(lg)>(t.far-t.near)**2))&&(ag.copy(r).invert(),dr.copy(t.ray).applyMatrix4(ag),!(n.boundingBox!==null&&dr.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(t,e,dr)))}_computeIntersections(t,e,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,f=r.groups,d=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,y=f.length;g<y;g++){let p=f[g],m=o[p.materialIndex],v=Math.max(p.start,d.start),C=Math.min(a.count,Math.min(p.start+p.count,d.start+d.count));for(let b=v,P=C;b<P;b+=3){let A=a.getX(b),x=a.getX(b+1),T=a.getX(b+2);s=hc(this,m,t,n,c,h,u,A,x,T),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=p.materialIndex,e.push(s))}}else{let g=Math.max(0,d.start),y=Math.min(a.count,d.start+d.count);for(let p=g,m=y;p<m;p+=3){let v=a.getX(p),C=a.getX(p+1),b=a.getX(p+2);s=hc(this,o,t,n,c,h,u,v,C,b),s&&(s.faceIndex=Math.floor(p/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let g=0,y=f.length;g<y;g++){let p=f[g],m=o[p.materialIndex],v=Math.max(p.start,d.start),C=Math.min(l.count,Math.min(p.start+p.count,d.start+d.count));for(let b=v,P=C;b<P;b+=3){let A=b,x=b+1,T=b+2;s=hc(this,m,t,n,c,h,u,A,x,T),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=p.materialIndex,e.push(s))}}else{let g=Math.max(0,d.start),y=Math.min(l.count,d.start+d.count);for(let p=g,m=y;p<m;p+=3){let v=p,C=p+1,b=p+2;s=hc(this,o,t,n,c,h,u,v,C,b),s&&(s.faceIndex=Math.floor(p/3),e.push(s))}}}};function IS(i,t,e,n,s,r,o,a){let l;if(t.side===ni?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,t.side===tr,a),l===null)return null;cc.copy(a),cc.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(cc);return c<e.near||c>e.far?null:{distance:c,point:cc.clone(),object:i}}function hc(i,t,e,n,s,r,o,a,l,c){i.getVertexPosition(a,rc),i.getVertexPosition(l,oc),i.getVertexPosition(c,ac);let h=IS(i,t,e,n,rc,oc,ac,cg);if(h){let u=new G;es.getBarycoord(cg,rc,oc,ac,u),s&&(h.uv=es.getInterpolatedAttribute(s,a,l,c,u,new Jt)),r&&(h.uv1=es.getInterpolatedAttribute(r,a,l,c,u,new Jt)),o&&(h.normal=es.getInterpolatedAttribute(o,a,l,c,u,new G),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let f={a,b:l,c,normal:new G,materialIndex:0};es.getNormal(rc,oc,ac,f.normal),h.face=f,h.barycoord=u}return h}var Fc=class extends ei{constructor(t=null,e=1,n=1,s,r,o,a,l,c=Un,h=Un,u,f){super(null,o,a,l,c,h,s,r,u,f),this.isDataTexture=!0,this.image={data:t,width:e,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var pr=new mr,LS=new Jt(.5,.5),uc=new G,Ys=class{constructor(t=new mi,e=new mi,n=new mi,s=new mi,r=new mi,o=new mi){this.planes=[t,e,n,s,r,o]}set(t,e,n,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let n=0;n<6;n++)e[n].copy(t.planes[n]);return this}setFromProjectionMatrix(t,e=Ti,n=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],h=r[4],u=r[5],f=r[6],d=r[7],g=r[8],y=r[9],p=r[10],m=r[11],v=r[12],C=r[13],b=r[14],P=r[15];if(s[0].setComponents(c-o,d-h,m-g,P-v).normalize(),s[1].setComponents(c+o,d+h,m+g,P+v).normalize(),s[2].setComponents(c+a,d+u,m+y,P+C).normalize(),s[3].setComponents(c-a,d-u,m-y,P-C).normalize(),n)s[4].setComponents(l,f,p,b).normalize(),s[5].setComponents(c-l,d-f,m-p,P-b).normalize();else if(s[4].setComponents(c-l,d-f,m-p,P-b).normalize(),e===Ti)s[5].setComponents(c+l,d+f,m+p,P+b).normalize();else if(e===po)s[5].setComponents(l,f,p,b).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),pr.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),pr.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(pr)}intersectsSprite(t){pr.center.set(0,0,0);let e=LS.distanceTo(t.center);return pr.radius=.7071067811865476+e,pr.applyMatrix4(t.matrixWorld),this.intersectsSphere(pr)}intersectsSphere(t){let e=this.planes,n=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let n=0;n<6;n++){let s=e[n];if(uc.x=s.normal.x>0?t.max.x:t.min.x,uc.y=s.normal.y>0?t.max.y:t.min.y,uc.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(uc)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let n=0;n<6;n++)if(e[n].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},hg=new De,Oc=class i{constructor(){this.coordinateSystem=Ti,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,n=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];hg.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new Ys),n[s].setFromProjectionMatrix(hg,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,n=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new Ys),e[s].copy(n[s]);return this._count=t._count,this}clone(){return new i().copy(this)}};var Ei=class extends is{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new ue(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},Bc=new G,kc=new G,ug=new De,ca=new gr,fc=new mr,xf=new G,fg=new G,vo=class extends Fn{constructor(t=new an,e=new Ei){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[0];for(let s=1,r=e.count;s<r;s++)Bc.fromBufferAttribute(e,s-1),kc.fromBufferAttribute(e,s),n[s]=n[s-1],n[s]+=Bc.distanceTo(kc);t.setAttribute("lineDistance",new Re(n,1))}else jt("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),fc.copy(n.boundingSphere),fc.applyMatrix4(s),fc.radius+=r,t.ray.intersectsSphere(fc)===!1)return;ug.copy(s).invert(),ca.copy(t.ray).applyMatrix4(ug);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=n.index,f=n.attributes.position;if(h!==null){let d=Math.max(0,o.start),g=Math.min(h.count,o.start+o.count);for(let y=d,p=g-1;y<p;y+=c){let m=h.getX(y),v=h.getX(y+1),C=dc(this,t,ca,l,m,v,y);C&&e.push(C)}if(this.isLineLoop){let y=h.getX(g-1),p=h.getX(d),m=dc(this,t,ca,l,y,p,g-1);m&&e.push(m)}}else{let d=Math.max(0,o.start),g=Math.min(f.count,o.start+o.count);for(let y=d,p=g-1;y<p;y+=c){let m=dc(this,t,ca,l,y,y+1,y);m&&e.push(m)}if(this.isLineLoop){let y=dc(this,t,ca,l,g-1,d,g-1);y&&e.push(y)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function dc(i,t,e,n,s,r,o){let a=i.geometry.attributes.position;if(Bc.fromBufferAttribute(a,s),kc.fromBufferAttribute(a,r),e.distanceSqToSegment(Bc,kc,xf,fg)>n)return;xf.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(xf);if(!(c<t.near||c>t.far))return{distance:c,point:fg.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var dg=new G,pg=new G,rs=class extends vo{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[];for(let s=0,r=e.count;s<r;s+=2)dg.fromBufferAttribute(e,s),pg.fromBufferAttribute(e,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+dg.distanceTo(pg);t.setAttribute("lineDistance",new Re(n,1))}else jt("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var wa=class extends ei{constructor(t=[],e=Sr,n,s,r,o,a,l,c,h){super(t,e,n,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}},Ta=class extends ei{constructor(t,e,n,s,r,o,a,l,c){super(t,e,n,s,r,o,a,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}};var As=class extends ei{constructor(t,e,n=Bi,s,r,o,a=Un,l=Un,c,h=Ts,u=1){if(h!==Ts&&h!==Rs)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let f={width:t,height:e,depth:u};super(f,s,r,o,a,l,h,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new _o(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},Ea=class extends As{constructor(t,e=Bi,n=Sr,s,r,o=Un,a=Un,l,c=Ts){let h={width:t,height:t,depth:1},u=[h,h,h,h,h,h];super(t,t,e,n,s,r,o,a,l,c),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},Aa=class extends ei{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},_i=class i extends an{constructor(t=1,e=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],h=[],u=[],f=0,d=0;g("z","y","x",-1,-1,n,e,t,o,r,0),g("z","y","x",1,-1,n,e,-t,o,r,1),g("x","z","y",1,1,t,n,e,s,o,2),g("x","z","y",1,-1,t,n,-e,s,o,3),g("x","y","z",1,-1,t,e,n,s,r,4),g("x","y","z",-1,-1,t,e,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new Re(c,3)),this.setAttribute("normal",new Re(h,3)),this.setAttribute("uv",new Re(u,2));function g(y,p,m,v,C,b,P,A,x,T,k){let U=b/x,N=P/T,z=b/2,W=P/2,D=A/2,X=x+1,Z=T+1,H=0,ht=0,j=new G;for(let tt=0;tt<Z;tt++){let rt=tt*N-W;for(let pt=0;pt<X;pt++){let dt=pt*U-z;j[y]=dt*v,j[p]=rt*C,j[m]=D,c.push(j.x,j.y,j.z),j[y]=0,j[p]=0,j[m]=A>0?1:-1,h.push(j.x,j.y,j.z),u.push(pt/x),u.push(1-tt/T),H+=1}}for(let tt=0;tt<T;tt++)for(let rt=0;rt<x;rt++){let pt=f+rt+X*tt,dt=f+rt+X*(tt+1),et=f+(rt+1)+X*(tt+1),xt=f+(rt+1)+X*tt;l.push(pt,dt,xt),l.push(dt,et,xt),ht+=6}a.addGroup(d,ht,k),d+=ht,f+=H}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var _r=class i extends an{constructor(t=1,e=1,n=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:n,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let h=[],u=[],f=[],d=[],g=0,y=[],p=n/2,m=0;v(),o===!1&&(t>0&&C(!0),e>0&&C(!1)),this.setIndex(h),this.setAttribute("position",new Re(u,3)),this.setAttribute("normal",new Re(f,3)),this.setAttribute("uv",new Re(d,2));function v(){let b=new G,P=new G,A=0,x=(e-t)/n;for(let T=0;T<=r;T++){let k=[],U=T/r,N=U*(e-t)+t;for(let z=0;z<=s;z++){let W=z/s,D=W*l+a,X=Math.sin(D),Z=Math.cos(D);P.x=N*X,P.y=-U*n+p,P.z=N*Z,u.push(P.x,P.y,P.z),b.set(X,x,Z).normalize(),f.push(b.x,b.y,b.z),d.push(W,1-U),k.push(g++)}y.push(k)}for(let T=0;T<s;T++)for(let k=0;k<r;k++){let U=y[k][T],N=y[k+1][T],z=y[k+1][T+1],W=y[k][T+1];(t>0||k!==0)&&(h.push(U,N,W),A+=3),(e>0||k!==r-1)&&(h.push(N,z,W),A+=3)}c.addGroup(m,A,0),m+=A}function C(b){let P=g,A=new Jt,x=new G,T=0,k=b===!0?t:e,U=b===!0?1:-1;for(let z=1;z<=s;z++)u.push(0,p*U,0),f.push(0,U,0),d.push(.5,.5),g++;let N=g;for(let z=0;z<=s;z++){let D=z/s*l+a,X=Math.cos(D),Z=Math.sin(D);x.x=k*Z,x.y=p*U,x.z=k*X,u.push(x.x,x.y,x.z),f.push(0,U,0),A.x=X*.5+.5,A.y=Z*.5*U+.5,d.push(A.x,A.y),g++}for(let z=0;z<s;z++){let W=P+z,D=N+z;b===!0?h.push(D,D+1,W):h.push(D+1,D,W),T+=3}c.addGroup(m,T,b===!0?1:2),m+=T}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}};var pc=new G,mc=new G,yf=new G,gc=new es,Ca=class extends an{constructor(t=null,e=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:t,thresholdAngle:e},t!==null){let s=Math.pow(10,4),r=Math.cos(ho*e),o=t.getIndex(),a=t.getAttribute("position"),l=o?o.count:a.count,c=[0,0,0],h=["a","b","c"],u=new Array(3),f=new Map,d=[];for(let g=0;g<l;g+=3){o?(c[0]=o.getX(g),c[1]=o.getX(g+1),c[2]=o.getX(g+2)):(c[0]=g,c[1]=g+1,c[2]=g+2);let{a:y,b:p,c:m}=gc;if(y.fromBufferAttribute(a,c[0]),p.fromBufferAttribute(a,c[1]),m.fromBufferAttribute(a,c[2]),gc.getNormal(yf),u[0]=`${Math.round(y.x*s)},${Math.round(y.y*s)},${Math.round(y.z*s)}`,u[1]=`${Math.round(p.x*s)},${Math.round(p.y*s)},${Math.round(p.z*s)}`,u[2]=`${Math.round(m.x*s)},${Math.round(m.y*s)},${Math.round(m.z*s)}`,!(u[0]===u[1]||u[1]===u[2]||u[2]===u[0]))for(let v=0;v<3;v++){let C=(v+1)%3,b=u[v],P=u[C],A=gc[h[v]],x=gc[h[C]],T=`${b}_${P}`,k=`${P}_${b}`,U=f.get(k);U?(yf.dot(U.normal)<=r&&(d.push(A.x,A.y,A.z),d.push(x.x,x.y,x.z)),f.set(k,null)):f.has(T)||f.set(T,{index0:c[v],index1:c[C],normal:yf.clone()})}}for(let g of f.values())if(g){let{index0:y,index1:p}=g;pc.fromBufferAttribute(a,y),mc.fromBufferAttribute(a,p),d.push(pc.x,pc.y,pc.z),d.push(mc.x,mc.y,mc.z)}this.setAttribute("position",new Re(d,3))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}};var Ra=class i extends an{constructor(t=1,e=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:n,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(n),l=Math.floor(s),c=a+1,h=l+1,u=t/a,f=e/l,d=[],g=[],y=[],p=[];for(let m=0;m<h;m++){let v=m*f-o;for(let C=0;C<c;C++){let b=C*u-r;g.push(b,-v,0),y.push(0,0,1),p.push(C/a),p.push(1-m/l)}}for(let m=0;m<l;m++)for(let v=0;v<a;v++){let C=v+c*m,b=v+c*(m+1),P=v+1+c*(m+1),A=v+1+c*m;d.push(C,b,A),d.push(b,P,A)}this.setIndex(d),this.setAttribute("position",new Re(g,3)),this.setAttribute("normal",new Re(y,3)),this.setAttribute("uv",new Re(p,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.widthSegments,t.heightSegments)}},Pa=class i extends an{constructor(t=.5,e=1,n=32,s=1,r=0,o=Math.PI*2){super(),this.type="RingGeometry",this.parameters={innerRadius:t,outerRadius:e,thetaSegments:n,phiSegments:s,thetaStart:r,thetaLength:o},n=Math.max(3,n),s=Math.max(1,s);let a=[],l=[],c=[],h=[],u=t,f=(e-t)/s,d=new G,g=new Jt;for(let y=0;y<=s;y++){for(let p=0;p<=n;p++){let m=r+p/n*o;d.x=u*Math.cos(m),d.y=u*Math.sin(m),l.push(d.x,d.y,d.z),c.push(0,0,1),g.x=(d.x/e+1)/2,g.y=(d.y/e+1)/2,h.push(g.x,g.y)}u+=f}for(let y=0;y<s;y++){let p=y*(n+1);for(let m=0;m<n;m++){let v=m+p,C=v,b=v+n+1,P=v+n+2,A=v+1;a.push(C,b,A),a.push(b,P,A)}}this.setIndex(a),this.setAttribute("position",new Re(l,3)),this.setAttribute("normal",new Re(c,3)),this.setAttribute("uv",new Re(h,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.innerRadius,t.outerRadius,t.thetaSegments,t.phiSegments,t.thetaStart,t.thetaLength)}};var xr=class i extends an{constructor(t=1,e=32,n=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:n,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),n=Math.max(2,Math.floor(n));let l=Math.min(o+a,Math.PI),c=0,h=[],u=new G,f=new G,d=[],g=[],y=[],p=[];for(let m=0;m<=n;m++){let v=[],C=m/n,b=o+C*a,P=t*Math.cos(b),A=Math.sqrt(t*t-P*P),x=0;m===0&&o===0?x=.5/e:m===n&&l===Math.PI&&(x=-.5/e);for(let T=0;T<=e;T++){let k=T/e,U=s+k*r;u.x=-A*Math.cos(U),u.y=P,u.z=A*Math.sin(U),g.push(u.x,u.y,u.z),f.copy(u).normalize(),y.push(f.x,f.y,f.z),p.push(k+x,1-C),v.push(c++)}h.push(v)}for(let m=0;m<n;m++)for(let v=0;v<e;v++){let C=h[m][v+1],b=h[m][v],P=h[m+1][v],A=h[m+1][v+1];(m!==0||o>0)&&d.push(C,b,A),(m!==n-1||l<Math.PI)&&d.push(b,P,A)}this.setIndex(d),this.setAttribute("position",new Re(g,3)),this.setAttribute("normal",new Re(y,3)),this.setAttribute("uv",new Re(p,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};function br(i){let t={};for(let e in i){t[e]={};for(let n in i[e]){let s=i[e][n];if(mg(s))s.isRenderTargetTexture?(jt("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][n]=null):t[e][n]=s.clone();else if(Array.isArray(s))if(mg(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][n]=r}else t[e][n]=s.slice();else t[e][n]=s}}return t}function Wn(i){let t={};for(let e=0;e<i.length;e++){let n=br(i[e]);for(let s in n)t[s]=n[s]}return t}function mg(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function DS(i){let t=[];for(let e=0;e<i.length;e++)t.push(i[e].clone());return t}function od(i){let t=i.getRenderTarget();return t===null?i.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:Me.workingColorSpace}var o0={clone:br,merge:Wn},NS=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,US=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,os=class extends is{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=NS,this.fragmentShader=US,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=br(t.uniforms),this.uniformsGroups=DS(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(e.extensions=n),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let n in t.uniforms){let s=t.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=e[s.value]||null;break;case"c":this.uniforms[n].value=new ue().setHex(s.value);break;case"v2":this.uniforms[n].value=new Jt().fromArray(s.value);break;case"v3":this.uniforms[n].value=new G().fromArray(s.value);break;case"v4":this.uniforms[n].value=new Qe().fromArray(s.value);break;case"m3":this.uniforms[n].value=new oe().fromArray(s.value);break;case"m4":this.uniforms[n].value=new De().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let n in t.extensions)this.extensions[n]=t.extensions[n];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},zc=class extends os{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}},as=class extends is{constructor(t){super(),this.isMeshStandardMaterial=!0,this.type="MeshStandardMaterial",this.defines={STANDARD:""},this.color=new ue(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new ue(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=zh,this.normalScale=new Jt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Es,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.defines={STANDARD:""},this.color.copy(t.color),this.roughness=t.roughness,this.metalness=t.metalness,this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.roughnessMap=t.roughnessMap,this.metalnessMap=t.metalnessMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.envMapIntensity=t.envMapIntensity,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}};var Vc=class extends is{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=qg,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},Gc=class extends is{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};var Ia=class extends Ei{constructor(t){super(),this.isLineDashedMaterial=!0,this.type="LineDashedMaterial",this.scale=1,this.dashSize=3,this.gapSize=1,this.setValues(t)}copy(t){return super.copy(t),this.scale=t.scale,this.dashSize=t.dashSize,this.gapSize=t.gapSize,this}};function ao(i,t){return!i||i.constructor===t?i:typeof t.BYTES_PER_ELEMENT=="number"?new t(i):Array.prototype.slice.call(i)}function _c(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var Zs=class{constructor(t,e,n,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(n),this.sampleValues=e,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,n=this._cachedIndex,s=e[n],r=e[n-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=n+2;;){if(s===void 0){if(t<r)break i;return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=e[++n],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=e[--n-1],t>=r)break t}o=n,n=0;break e}break n}for(;n<o;){let a=n+o>>>1;t<e[a]?o=a:n=a+1}if(s=e[n],r=e[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=n[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Hc=class extends Zs{constructor(t,e,n,s){super(t,e,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Mf,endingEnd:Mf}}intervalChanged_(t,e,n){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case bf:r=t,a=2*e-n;break;case wf:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case bf:o=t,l=2*n-e;break;case wf:o=1,l=n+s[1]-s[0];break;default:o=t-1,l=e}let c=(n-e)*.5,h=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-n),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=this._offsetPrev,u=this._offsetNext,f=this._weightPrev,d=this._weightNext,g=(n-e)/(s-e),y=g*g,p=y*g,m=-f*p+2*f*y-f*g,v=(1+f)*p+(-1.5-2*f)*y+(-.5+f)*g+1,C=(-1-d)*p+(1.5+d)*y+.5*g,b=d*p-d*y;for(let P=0;P!==a;++P)r[P]=m*o[h+P]+v*o[c+P]+C*o[l+P]+b*o[u+P];return r}},Wc=class extends Zs{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=(n-e)/(s-e),u=1-h;for(let f=0;f!==a;++f)r[f]=o[c+f]*u+o[l+f]*h;return r}},Xc=class extends Zs{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t){return this.copySampleValue_(t-1)}},qc=class extends Zs{interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=this.inTangents,u=this.outTangents;if(!h||!u){let g=(n-e)/(s-e),y=1-g;for(let p=0;p!==a;++p)r[p]=o[c+p]*y+o[l+p]*g;return r}let f=a*2,d=t-1;for(let g=0;g!==a;++g){let y=o[c+g],p=o[l+g],m=d*f+g*2,v=u[m],C=u[m+1],b=t*f+g*2,P=h[b],A=h[b+1],x=OS(n,e,v,P,s);r[g]=a0(x,y,C,A,p)}return r}};function a0(i,t,e,n,s){let r=1-i;return r*r*r*t+3*r*r*i*e+3*r*i*i*n+i*i*i*s}function FS(i,t,e,n,s){let r=1-i;return 3*r*r*(e-t)+6*r*i*(n-e)+3*i*i*(s-n)}function OS(i,t,e,n,s){let r=(i-t)/(s-t);for(let o=0;o<8;o++){let a=a0(r,t,e,n,s)-i;if(Math.abs(a)<1e-10)break;let l=FS(r,t,e,n,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var xi=class{constructor(t,e,n,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=ao(e,this.TimeBufferType),this.values=ao(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,n;if(e.toJSON!==this.toJSON)n=e.toJSON(t);else{n={name:t.name,times:ao(t.times,Array),values:ao(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(n.interpolation=s),_c(t.settings)&&(n.settings={inTangents:ao(t.settings.inTangents,Array),outTangents:ao(t.settings.outTangents,Array)})}return n.type=t.ValueTypeName,n}InterpolantFactoryMethodDiscrete(t){return new Xc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new Wc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new Hc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new qc(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case fa:e=this.InterpolantFactoryMethodDiscrete;break;case Ic:e=this.InterpolantFactoryMethodLinear;break;case vc:e=this.InterpolantFactoryMethodSmooth;break;case Sf:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return jt("KeyframeTrack:",n),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return fa;case this.InterpolantFactoryMethodLinear:return Ic;case this.InterpolantFactoryMethodSmooth:return vc;case this.InterpolantFactoryMethodBezier:return Sf}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]+=t;_c(this.settings)&&(gg(this.settings.inTangents,t),gg(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]*=t;_c(this.settings)&&(_g(this.settings.inTangents,t),_g(this.settings.outTangents,t))}return this}trim(t,e){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<t;)++r;for(;o!==-1&&n[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(se("KeyframeTrack: Invalid value size in track.",this),t=!1);let n=this.times,s=this.values,r=n.length;r===0&&(se("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){se("KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){se("KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&Qv(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){se("KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===vc,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],h=t[a+1];if(c!==h&&(a!==1||c!==t[0]))if(s)l=!0;else{let u=a*n,f=u-n,d=u+n;for(let g=0;g!==n;++g){let y=e[u+g];if(y!==e[f+g]||y!==e[d+g]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let u=a*n,f=o*n;for(let d=0;d!==n;++d)e[f+d]=e[u+d]}++o}}if(r>0){t[o]=t[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*n)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),n=this.constructor,s=new n(this.name,t,e);return s.createInterpolant=this.createInterpolant,_c(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function gg(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]+=t}function _g(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]*=t}xi.prototype.ValueTypeName="";xi.prototype.TimeBufferType=Float32Array;xi.prototype.ValueBufferType=Float32Array;xi.prototype.DefaultInterpolation=Ic;var Js=class extends xi{constructor(t,e,n){super(t,e,n)}};Js.prototype.ValueTypeName="bool";Js.prototype.ValueBufferType=Array;Js.prototype.DefaultInterpolation=fa;Js.prototype.InterpolantFactoryMethodLinear=void 0;Js.prototype.InterpolantFactoryMethodSmooth=void 0;var $c=class extends xi{constructor(t,e,n,s){super(t,e,n,s)}};$c.prototype.ValueTypeName="color";var Yc=class extends xi{constructor(t,e,n,s){super(t,e,n,s)}};Yc.prototype.ValueTypeName="number";var Zc=class extends Zs{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-e)/(s-e),c=t*a;for(let h=c+a;c!==h;c+=4)ti.slerpFlat(r,0,o,c-a,o,c,l);return r}},La=class extends xi{constructor(t,e,n,s){super(t,e,n,s)}InterpolantFactoryMethodLinear(t){return new Zc(this.times,this.values,this.getValueSize(),t)}};La.prototype.ValueTypeName="quaternion";La.prototype.InterpolantFactoryMethodSmooth=void 0;var Ks=class extends xi{constructor(t,e,n){super(t,e,n)}};Ks.prototype.ValueTypeName="string";Ks.prototype.ValueBufferType=Array;Ks.prototype.DefaultInterpolation=fa;Ks.prototype.InterpolantFactoryMethodLinear=void 0;Ks.prototype.InterpolantFactoryMethodSmooth=void 0;var Jc=class extends xi{constructor(t,e,n,s){super(t,e,n,s)}};Jc.prototype.ValueTypeName="vector";var Kc=class{constructor(t,e,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=n,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,u){return c.push(h,u),this},this.removeHandler=function(h){let u=c.indexOf(h);return u!==-1&&c.splice(u,2),this},this.getHandler=function(h){for(let u=0,f=c.length;u<f;u+=2){let d=c[u],g=c[u+1];if(d.global&&(d.lastIndex=0),d.test(h))return g}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},l0=new Kc,jc=class{constructor(t){this.manager=t!==void 0?t:l0,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let n=this;return new Promise(function(s,r){n.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};jc.DEFAULT_MATERIAL_NAME="__DEFAULT";var So=class extends Fn{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new ue(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}},Da=class extends So{constructor(t,e,n){super(t,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Fn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new ue(e)}copy(t,e){return super.copy(t,e),this.groundColor.copy(t.groundColor),this}toJSON(t){let e=super.toJSON(t);return e.object.groundColor=this.groundColor.getHex(),e}},vf=new De,xg=new G,yg=new G,Qc=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Jt(512,512),this.mapType=ai,this.map=null,this.mapPass=null,this.matrix=new De,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Ys,this._frameExtents=new Jt(1,1),this._viewportCount=1,this._viewports=[new Qe(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;xg.setFromMatrixPosition(t.matrixWorld),e.position.copy(xg),yg.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(yg),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,n,s){vf.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),n.setFromProjectionMatrix(vf,t.coordinateSystem,t.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;t.coordinateSystem===po||t.reversedDepth?e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),e.multiply(vf)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},xc=new G,yc=new ti,ts=new G,Na=class extends Fn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new De,this.projectionMatrix=new De,this.projectionMatrixInverse=new De,this.coordinateSystem=Ti,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(xc,yc,ts),ts.x===1&&ts.y===1&&ts.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(xc,yc,ts.set(1,1,1)).invert()}updateWorldMatrix(t,e,n=!1){super.updateWorldMatrix(t,e,n),this.matrixWorld.decompose(xc,yc,ts),ts.x===1&&ts.y===1&&ts.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(xc,yc,ts.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},qs=new G,vg=new Jt,Sg=new Jt,jn=class extends Na{constructor(t=50,e=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=go*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(ho*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return go*2*Math.atan(Math.tan(ho*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,n){qs.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(qs.x,qs.y).multiplyScalar(-t/qs.z),qs.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(qs.x,qs.y).multiplyScalar(-t/qs.z)}getViewSize(t,e){return this.getViewBounds(t,vg,Sg),e.subVectors(Sg,vg)}setViewOffset(t,e,n,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(ho*.5*this.fov)/this.zoom,n=2*e,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-n,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var Ua=class extends Na{constructor(t=-1,e=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-t,o=n+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},Tf=class extends Qc{constructor(){super(new Ua(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Fa=class extends So{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Fn.DEFAULT_UP),this.updateMatrix(),this.target=new Fn,this.shadow=new Tf}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}},Oa=class extends So{constructor(t,e){super(t,e),this.isAmbientLight=!0,this.type="AmbientLight"}};var lo=-90,co=1,Mo=class extends Fn{constructor(t,e,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new jn(lo,co,t,e);s.layers=this.layers,this.add(s);let r=new jn(lo,co,t,e);r.layers=this.layers,this.add(r);let o=new jn(lo,co,t,e);o.layers=this.layers,this.add(o);let a=new jn(lo,co,t,e);a.layers=this.layers,this.add(a);let l=new jn(lo,co,t,e);l.layers=this.layers,this.add(l);let c=new jn(lo,co,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[n,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===Ti)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===po)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,h]=this.children,u=t.getRenderTarget(),f=t.getActiveCubeFace(),d=t.getActiveMipmapLevel(),g=t.xr.enabled;t.xr.enabled=!1;let y=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let p=!1;t.isWebGLRenderer===!0?p=t.state.buffers.depth.getReversed():p=t.reversedDepthBuffer,t.setRenderTarget(n,0,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(n,1,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(n,2,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(n,3,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(n,4,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),n.texture.mipmapsAutoUpdate=y,t.setRenderTarget(n,5,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,h),t.setRenderTarget(u,f,d),t.xr.enabled=g,n.texture.needsPMREMUpdate=!0}},th=class extends jn{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var ad="\\[\\]\\.:\\/",BS=new RegExp("["+ad+"]","g"),ld="[^"+ad+"]",kS="[^"+ad.replace("\\.","")+"]",zS=/((?:WC+[\/:])*)/.source.replace("WC",ld),VS=/(WCOD+)?/.source.replace("WCOD",kS),GS=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",ld),HS=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",ld),WS=new RegExp("^"+zS+VS+GS+HS+"$"),XS=["material","materials","bones","map"],Ef=class{constructor(t,e,n){let s=n||Ze.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(t,e)}setValue(t,e){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].unbind()}},Ze=class i{constructor(t,e,n){this.path=e,this.parsedPath=n||i.parseTrackName(e),this.node=i.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,n){return t&&t.isAnimationObjectGroup?new i.Composite(t,e,n):new i(t,e,n)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(BS,"")}static parseTrackName(t){let e=WS.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let n={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);XS.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return n}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let n=t.skeleton.getBoneByName(e);if(n!==void 0)return n}if(t.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=n(a.children);if(l)return l}return null},s=n(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)t[e++]=n[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,n=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=i.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){jt("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=e.objectIndex;switch(n){case"materials":if(!t.material){se("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){se("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){se("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let h=0;h<t.length;h++)if(t[h].name===c){c=h;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){se("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){se("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[n]===void 0){se("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[n]}if(c!==void 0){if(t[c]===void 0){se("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;se("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){se("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){se("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Ze.Composite=Ef;Ze.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Ze.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Ze.prototype.GetterByBindingType=[Ze.prototype._getValue_direct,Ze.prototype._getValue_array,Ze.prototype._getValue_arrayElement,Ze.prototype._getValue_toArray];Ze.prototype.SetterByBindingTypeAndVersioning=[[Ze.prototype._setValue_direct,Ze.prototype._setValue_direct_setNeedsUpdate,Ze.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Ze.prototype._setValue_array,Ze.prototype._setValue_array_setNeedsUpdate,Ze.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Ze.prototype._setValue_arrayElement,Ze.prototype._setValue_arrayElement_setNeedsUpdate,Ze.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Ze.prototype._setValue_fromArray,Ze.prototype._setValue_fromArray_setNeedsUpdate,Ze.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var p2=new Float32Array(1);var bo=class{constructor(t=1,e=0,n=0){this.radius=t,this.phi=e,this.theta=n}set(t,e,n){return this.radius=t,this.phi=e,this.theta=n,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=ye(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,n){return this.radius=Math.sqrt(t*t+e*e+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,n),this.phi=Math.acos(ye(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Af=class{static{this.prototype.isMatrix2=!0}constructor(t,e,n,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let n=0;n<4;n++)this.elements[n]=t[n+e];return this}set(t,e,n,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=n,r[3]=s,this}};var Ba=class extends rs{constructor(t=10,e=10,n=4473924,s=8947848){n=new ue(n),s=new ue(s);let r=e/2,o=t/e,a=t/2,l=[],c=[];for(let f=0,d=0,g=-a;f<=e;f++,g+=o){l.push(-a,0,g,a,0,g),l.push(g,0,-a,g,0,a);let y=f===r?n:s;y.toArray(c,d),d+=3,y.toArray(c,d),d+=3,y.toArray(c,d),d+=3,y.toArray(c,d),d+=3}let h=new an;h.setAttribute("position",new Re(l,3)),h.setAttribute("color",new Re(c,3));let u=new Ei({vertexColors:!0,toneMapped:!1});super(h,u),this.type="GridHelper"}dispose(){super.dispose(),this.geometry.dispose(),this.material.dispose()}};var ka=class extends Oi{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function cd(i,t,e,n){let s=qS(n);switch(e){case $f:return i*t;case Zf:return i*t/s.components*s.byteLength;case ah:return i*t/s.components*s.byteLength;case er:return i*t*2/s.components*s.byteLength;case lh:return i*t*2/s.components*s.byteLength;case Yf:return i*t*3/s.components*s.byteLength;case Vi:return i*t*4/s.components*s.byteLength;case ch:return i*t*4/s.components*s.byteLength;case Ga:case Ha:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case Wa:case Xa:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case uh:case dh:return Math.max(i,16)*Math.max(t,8)/4;case hh:case fh:return Math.max(i,8)*Math.max(t,8)/2;case ph:case mh:case _h:case xh:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case gh:case qa:case yh:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case vh:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case Sh:return Math.floor((i+4)/5)*Math.floor((t+3)/4)*16;case Mh:return Math.floor((i+4)/5)*Math.floor((t+4)/5)*16;case bh:return Math.floor((i+5)/6)*Math.floor((t+4)/5)*16;case wh:return Math.floor((i+5)/6)*Math.floor((t+5)/6)*16;case Th:return Math.floor((i+7)/8)*Math.floor((t+4)/5)*16;case Eh:return Math.floor((i+7)/8)*Math.floor((t+5)/6)*16;case Ah:return Math.floor((i+7)/8)*Math.floor((t+7)/8)*16;case Ch:return Math.floor((i+9)/10)*Math.floor((t+4)/5)*16;case Rh:return Math.floor((i+9)/10)*Math.floor((t+5)/6)*16;case Ph:return Math.floor((i+9)/10)*Math.floor((t+7)/8)*16;case Ih:return Math.floor((i+9)/10)*Math.floor((t+9)/10)*16;case Lh:return Math.floor((i+11)/12)*Math.floor((t+9)/10)*16;case Dh:return Math.floor((i+11)/12)*Math.floor((t+11)/12)*16;case Nh:case Uh:case Fh:return Math.ceil(i/4)*Math.ceil(t/4)*16;case Oh:case Bh:return Math.ceil(i/4)*Math.ceil(t/4)*8;case $a:case kh:return Math.ceil(i/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function qS(i){switch(i){case ai:case Hf:return{byteLength:1,components:1};case Ao:case Wf:case zi:return{byteLength:2,components:1};case rh:case oh:return{byteLength:2,components:4};case Bi:case sh:case ki:return{byteLength:4,components:1};case Xf:case qf:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?jt("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */function P0(){let i=null,t=!1,e=null,n=null;function s(r,o){n=i.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&i!==null&&(n=i.requestAnimationFrame(s),t=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){i=r}}}function YS(i){let t=new WeakMap;function e(a,l){let c=a.array,h=a.usage,u=c.byteLength,f=i.createBuffer();i.bindBuffer(l,f),i.bufferData(l,c,h),a.onUploadCallback();let d;if(c instanceof Float32Array)d=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)d=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?d=i.HALF_FLOAT:d=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)d=i.SHORT;else if(c instanceof Uint32Array)d=i.UNSIGNED_INT;else if(c instanceof Int32Array)d=i.INT;else if(c instanceof Int8Array)d=i.BYTE;else if(c instanceof Uint8Array)d=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)d=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:d,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:u}}function n(a,l,c){let h=l.array,u=l.updateRanges;if(i.bindBuffer(c,a),u.length===0)i.bufferSubData(c,0,h);else{u.sort((d,g)=>d.start-g.start);let f=0;for(let d=1;d<u.length;d++){let g=u[f],y=u[d];y.start<=g.start+g.count+1?g.count=Math.max(g.count,y.start+y.count-g.start):(++f,u[f]=y)}u.length=f+1;for(let d=0,g=u.length;d<g;d++){let y=u[d];i.bufferSubData(c,y.start*h.BYTES_PER_ELEMENT,h,y.start,y.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(i.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=t.get(a);(!h||h.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var ZS=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,JS=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,KS=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,jS=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,QS=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,tM=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,eM=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,nM=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,iM=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,sM=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,rM=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,oM=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,aM=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,lM=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,cM=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,hM=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,uM=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,fM=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,dM=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,pM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,mM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,gM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,_M=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,xM=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,yM=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,vM=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,SM=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,MM=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,bM=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,wM="gl_FragColor = linearToOutputTexel( gl_FragColor );",TM=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,EM=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,AM=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,CM=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,RM=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,PM=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,IM=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,LM=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,DM=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,NM=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,UM=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,FM=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,OM=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,BM=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,kM=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,zM=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,VM=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,GM=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,HM=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,WM=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,XM=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,qM=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,$M=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,YM=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,ZM=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,JM=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,KM=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,jM=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,QM=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,tb=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,eb=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,nb=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,ib=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,sb=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,rb=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,ob=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,ab=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,lb=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,cb=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,hb=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,ub=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,fb=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,db=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,pb=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,mb=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,gb=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,_b=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,xb=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,yb=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,vb=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,Sb=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,Mb=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,bb=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,wb=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,Tb=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,Eb=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,Ab=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,Cb=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,Rb=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,Pb=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,Ib=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,Lb=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,Db=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,Nb=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,Ub=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,Fb=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,Ob=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,Bb=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,kb=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,zb=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,Vb=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,Gb=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,Hb=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,Wb=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,Xb=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,qb=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,$b=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,Yb=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,Zb=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Jb=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Kb=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,jb=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Qb=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,tw=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,ew=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,nw=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,iw=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,sw=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,rw=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,ow=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,aw=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,lw=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,cw=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,hw=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,uw=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,fw=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,dw=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,pw=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,mw=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,gw=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,_w=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,xw=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,yw=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,vw=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Sw=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Mw=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,bw=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,ww=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Tw=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Ew=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,Aw=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,me={alphahash_fragment:ZS,alphahash_pars_fragment:JS,alphamap_fragment:KS,alphamap_pars_fragment:jS,alphatest_fragment:QS,alphatest_pars_fragment:tM,aomap_fragment:eM,aomap_pars_fragment:nM,batching_pars_vertex:iM,batching_vertex:sM,begin_vertex:rM,beginnormal_vertex:oM,bsdfs:aM,iridescence_fragment:lM,bumpmap_pars_fragment:cM,clipping_planes_fragment:hM,clipping_planes_pars_fragment:uM,clipping_planes_pars_vertex:fM,clipping_planes_vertex:dM,color_fragment:pM,color_pars_fragment:mM,color_pars_vertex:gM,color_vertex:_M,common:xM,defaultnormal_vertex:yM,displacementmap_pars_vertex:vM,displacementmap_vertex:SM,emissivemap_fragment:MM,emissivemap_pars_fragment:bM,colorspace_fragment:wM,colorspace_pars_fragment:TM,envmap_fragment:EM,envmap_common_pars_fragment:AM,envmap_pars_fragment:CM,envmap_pars_vertex:RM,envmap_physical_pars_fragment:zM,envmap_vertex:PM,fog_vertex:IM,fog_pars_vertex:LM,fog_fragment:DM,fog_pars_fragment:NM,gradientmap_pars_fragment:UM,lightmap_pars_fragment:FM,lights_lambert_fragment:OM,lights_lambert_pars_fragment:BM,lights_pars_begin:kM,lights_toon_fragment:VM,lights_toon_pars_fragment:GM,lights_phong_fragment:HM,lights_phong_pars_fragment:WM,lights_physical_fragment:XM,lights_physical_pars_fragment:qM,lights_fragment_begin:$M,lights_fragment_maps:YM,lights_fragment_end:ZM,lightprobes_pars_fragment:JM,logdepthbuf_fragment:KM,logdepthbuf_pars_fragment:jM,logdepthbuf_pars_vertex:QM,logdepthbuf_vertex:tb,map_fragment:eb,map_pars_fragment:nb,map_particle_fragment:ib,map_particle_pars_fragment:sb,metalnessmap_fragment:rb,metalnessmap_pars_fragment:ob,morphinstance_vertex:ab,morphcolor_vertex:lb,morphnormal_vertex:cb,morphtarget_pars_vertex:hb,morphtarget_vertex:ub,normal_fragment_begin:fb,normal_fragment_maps:db,normal_pars_fragment:pb,normal_pars_vertex:mb,normal_vertex:gb,normalmap_pars_fragment:_b,clearcoat_normal_fragment_begin:xb,clearcoat_normal_fragment_maps:yb,clearcoat_pars_fragment:vb,iridescence_pars_fragment:Sb,opaque_fragment:Mb,packing:bb,premultiplied_alpha_fragment:wb,project_vertex:Tb,dithering_fragment:Eb,dithering_pars_fragment:Ab,roughnessmap_fragment:Cb,roughnessmap_pars_fragment:Rb,shadowmap_pars_fragment:Pb,shadowmap_pars_vertex:Ib,shadowmap_vertex:Lb,shadowmask_pars_fragment:Db,skinbase_vertex:Nb,skinning_pars_vertex:Ub,skinning_vertex:Fb,skinnormal_vertex:Ob,specularmap_fragment:Bb,specularmap_pars_fragment:kb,tonemapping_fragment:zb,tonemapping_pars_fragment:Vb,transmission_fragment:Gb,transmission_pars_fragment:Hb,uv_pars_fragment:Wb,uv_pars_vertex:Xb,uv_vertex:qb,worldpos_vertex:$b,background_vert:Yb,background_frag:Zb,backgroundCube_vert:Jb,backgroundCube_frag:Kb,cube_vert:jb,cube_frag:Qb,depth_vert:tw,depth_frag:ew,distance_vert:nw,distance_frag:iw,equirect_vert:sw,equirect_frag:rw,linedashed_vert:ow,linedashed_frag:aw,meshbasic_vert:lw,meshbasic_frag:cw,meshlambert_vert:hw,meshlambert_frag:uw,meshmatcap_vert:fw,meshmatcap_frag:dw,meshnormal_vert:pw,meshnormal_frag:mw,meshphong_vert:gw,meshphong_frag:_w,meshphysical_vert:xw,meshphysical_frag:yw,meshtoon_vert:vw,meshtoon_frag:Sw,points_vert:Mw,points_frag:bw,shadow_vert:ww,shadow_frag:Tw,sprite_vert:Ew,sprite_frag:Aw},Ut={common:{diffuse:{value:new ue(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new oe},alphaMap:{value:null},alphaMapTransform:{value:new oe},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new oe}},envmap:{envMap:{value:null},envMapRotation:{value:new oe},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new oe}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new oe}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new oe},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new oe},normalScale:{value:new Jt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new oe},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new oe}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new oe}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new oe}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new ue(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new ue(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new oe},alphaTest:{value:0},uvTransform:{value:new oe}},sprite:{diffuse:{value:new ue(16777215)},opacity:{value:1},center:{value:new Jt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new oe},alphaMap:{value:null},alphaMapTransform:{value:new oe},alphaTest:{value:0}}},hs={basic:{uniforms:Wn([Ut.common,Ut.specularmap,Ut.envmap,Ut.aomap,Ut.lightmap,Ut.fog]),vertexShader:me.meshbasic_vert,fragmentShader:me.meshbasic_frag},lambert:{uniforms:Wn([Ut.common,Ut.specularmap,Ut.envmap,Ut.aomap,Ut.lightmap,Ut.emissivemap,Ut.bumpmap,Ut.normalmap,Ut.displacementmap,Ut.fog,Ut.lights,{emissive:{value:new ue(0)},envMapIntensity:{value:1}}]),vertexShader:me.meshlambert_vert,fragmentShader:me.meshlambert_frag},phong:{uniforms:Wn([Ut.common,Ut.specularmap,Ut.envmap,Ut.aomap,Ut.lightmap,Ut.emissivemap,Ut.bumpmap,Ut.normalmap,Ut.displacementmap,Ut.fog,Ut.lights,{emissive:{value:new ue(0)},specular:{value:new ue(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:me.meshphong_vert,fragmentShader:me.meshphong_frag},standard:{uniforms:Wn([Ut.common,Ut.envmap,Ut.aomap,Ut.lightmap,Ut.emissivemap,Ut.bumpmap,Ut.normalmap,Ut.displacementmap,Ut.roughnessmap,Ut.metalnessmap,Ut.fog,Ut.lights,{emissive:{value:new ue(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:me.meshphysical_vert,fragmentShader:me.meshphysical_frag},toon:{uniforms:Wn([Ut.common,Ut.aomap,Ut.lightmap,Ut.emissivemap,Ut.bumpmap,Ut.normalmap,Ut.displacementmap,Ut.gradientmap,Ut.fog,Ut.lights,{emissive:{value:new ue(0)}}]),vertexShader:me.meshtoon_vert,fragmentShader:me.meshtoon_frag},matcap:{uniforms:Wn([Ut.common,Ut.bumpmap,Ut.normalmap,Ut.displacementmap,Ut.fog,{matcap:{value:null}}]),vertexShader:me.meshmatcap_vert,fragmentShader:me.meshmatcap_frag},points:{uniforms:Wn([Ut.points,Ut.fog]),vertexShader:me.points_vert,fragmentShader:me.points_frag},dashed:{uniforms:Wn([Ut.common,Ut.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:me.linedashed_vert,fragmentShader:me.linedashed_frag},depth:{uniforms:Wn([Ut.common,Ut.displacementmap]),vertexShader:me.depth_vert,fragmentShader:me.depth_frag},normal:{uniforms:Wn([Ut.common,Ut.bumpmap,Ut.normalmap,Ut.displacementmap,{opacity:{value:1}}]),vertexShader:me.meshnormal_vert,fragmentShader:me.meshnormal_frag},sprite:{uniforms:Wn([Ut.sprite,Ut.fog]),vertexShader:me.sprite_vert,fragmentShader:me.sprite_frag},background:{uniforms:{uvTransform:{value:new oe},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:me.background_vert,fragmentShader:me.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new oe}},vertexShader:me.backgroundCube_vert,fragmentShader:me.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:me.cube_vert,fragmentShader:me.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:me.equirect_vert,fragmentShader:me.equirect_frag},distance:{uniforms:Wn([Ut.common,Ut.displacementmap,{referencePosition:{value:new G},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:me.distance_vert,fragmentShader:me.distance_frag},shadow:{uniforms:Wn([Ut.lights,Ut.fog,{color:{value:new ue(0)},opacity:{value:1}}]),vertexShader:me.shadow_vert,fragmentShader:me.shadow_frag}};hs.physical={uniforms:Wn([hs.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new oe},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new oe},clearcoatNormalScale:{value:new Jt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new oe},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new oe},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new oe},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new oe},sheen:{value:0},sheenColor:{value:new ue(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new oe},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new oe},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new oe},transmissionSamplerSize:{value:new Jt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new oe},attenuationDistance:{value:0},attenuationColor:{value:new ue(0)},specularColor:{value:new ue(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new oe},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new oe},anisotropyVector:{value:new Jt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new oe}}]),vertexShader:me.meshphysical_vert,fragmentShader:me.meshphysical_frag};var Gh={r:0,b:0,g:0},Cw=new De,I0=new oe;I0.set(-1,0,0,0,1,0,0,0,1);function Rw(i,t,e,n,s,r){let o=new ue(0),a=s===!0?0:1,l,c,h=null,u=0,f=null;function d(v){let C=v.isScene===!0?v.background:null;if(C&&C.isTexture){let b=v.backgroundBlurriness>0;C=t.get(C,b)}return C}function g(v){let C=!1,b=d(v);b===null?p(o,a):b&&b.isColor&&(p(b,1),C=!0);let P=i.xr.getEnvironmentBlendMode();P==="additive"?e.buffers.color.setClear(0,0,0,1,r):P==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(i.autoClear||C)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function y(v,C){let b=d(C);b&&b.isCubeTexture?(c===void 0&&(c=new bn(new _i(1,1,1),new os({name:"BackgroundCubeMaterial",uniforms:br(hs.backgroundCube.uniforms),vertexShader:hs.backgroundCube.vertexShader,fragmentShader:hs.backgroundCube.fragmentShader,side:ni,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(P,A,x){this.matrixWorld.copyPosition(x.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=b,c.material.uniforms.backgroundBlurriness.value=C.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=C.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(Cw.makeRotationFromEuler(C.backgroundRotation)).transpose(),b.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(I0),c.material.toneMapped=Me.getTransfer(b.colorSpace)!==Le,(h!==b||u!==b.version||f!==i.toneMapping)&&(c.material.needsUpdate=!0,h=b,u=b.version,f=i.toneMapping),c.layers.enableAll(),v.unshift(c,c.geometry,c.material,0,0,null)):b&&b.isTexture&&(l===void 0&&(l=new bn(new Ra(2,2),new os({name:"BackgroundMaterial",uniforms:br(hs.background.uniforms),vertexShader:hs.background.vertexShader,fragmentShader:hs.background.fragmentShader,side:tr,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=b,l.material.uniforms.backgroundIntensity.value=C.backgroundIntensity,l.material.toneMapped=Me.getTransfer(b.colorSpace)!==Le,b.matrixAutoUpdate===!0&&b.updateMatrix(),l.material.uniforms.uvTransform.value.copy(b.matrix),(h!==b||u!==b.version||f!==i.toneMapping)&&(l.material.needsUpdate=!0,h=b,u=b.version,f=i.toneMapping),l.layers.enableAll(),v.unshift(l,l.geometry,l.material,0,0,null))}function p(v,C){v.getRGB(Gh,od(i)),e.buffers.color.setClear(Gh.r,Gh.g,Gh.b,C,r)}function m(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(v,C=1){o.set(v),a=C,p(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(v){a=v,p(o,a)},render:g,addToRenderList:y,dispose:m}}function Pw(i,t){let e=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=f(null),r=s,o=!1;function a(N,z,W,D,X){let Z=!1,H=u(N,D,W,z);r!==H&&(r=H,c(r.object)),Z=d(N,D,W,X),Z&&g(N,D,W,X),X!==null&&t.update(X,i.ELEMENT_ARRAY_BUFFER),(Z||o)&&(o=!1,b(N,z,W,D),X!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,t.get(X).buffer))}function l(){return i.createVertexArray()}function c(N){return i.bindVertexArray(N)}function h(N){return i.deleteVertexArray(N)}function u(N,z,W,D){let X=D.wireframe===!0,Z=n[z.id];Z===void 0&&(Z={},n[z.id]=Z);let H=N.isInstancedMesh===!0?N.id:0,ht=Z[H];ht===void 0&&(ht={},Z[H]=ht);let j=ht[W.id];j===void 0&&(j={},ht[W.id]=j);let tt=j[X];return tt===void 0&&(tt=f(l()),j[X]=tt),tt}function f(N){let z=[],W=[],D=[];for(let X=0;X<e;X++)z[X]=0,W[X]=0,D[X]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:z,enabledAttributes:W,attributeDivisors:D,object:N,attributes:{},index:null}}function d(N,z,W,D){let X=r.attributes,Z=z.attributes,H=0,ht=W.getAttributes();for(let j in ht)if(ht[j].location>=0){let rt=X[j],pt=Z[j];if(pt===void 0&&(j==="instanceMatrix"&&N.instanceMatrix&&(pt=N.instanceMatrix),j==="instanceColor"&&N.instanceColor&&(pt=N.instanceColor)),rt===void 0||rt.attribute!==pt||pt&&rt.data!==pt.data)return!0;H++}return r.attributesNum!==H||r.index!==D}function g(N,z,W,D){let X={},Z=z.attributes,H=0,ht=W.getAttributes();for(let j in ht)if(ht[j].location>=0){let rt=Z[j];rt===void 0&&(j==="instanceMatrix"&&N.instanceMatrix&&(rt=N.instanceMatrix),j==="instanceColor"&&N.instanceColor&&(rt=N.instanceColor));let pt={};pt.attribute=rt,rt&&rt.data&&(pt.data=rt.data),X[j]=pt,H++}r.attributes=X,r.attributesNum=H,r.index=D}function y(){let N=r.newAttributes;for(let z=0,W=N.length;z<W;z++)N[z]=0}function p(N){m(N,0)}function m(N,z){let W=r.newAttributes,D=r.enabledAttributes,X=r.attributeDivisors;W[N]=1,D[N]===0&&(i.enableVertexAttribArray(N),D[N]=1),X[N]!==z&&(i.vertexAttribDivisor(N,z),X[N]=z)}function v(){let N=r.newAttributes,z=r.enabledAttributes;for(let W=0,D=z.length;W<D;W++)z[W]!==N[W]&&(i.disableVertexAttribArray(W),z[W]=0)}function C(N,z,W,D,X,Z,H){H===!0?i.vertexAttribIPointer(N,z,W,X,Z):i.vertexAttribPointer(N,z,W,D,X,Z)}function b(N,z,W,D){y();let X=D.attributes,Z=W.getAttributes(),H=z.defaultAttributeValues;for(let ht in Z){let j=Z[ht];if(j.location>=0){let tt=X[ht];if(tt===void 0&&(ht==="instanceMatrix"&&N.instanceMatrix&&(tt=N.instanceMatrix),ht==="instanceColor"&&N.instanceColor&&(tt=N.instanceColor)),tt!==void 0){let rt=tt.normalized,pt=tt.itemSize,dt=t.get(tt);if(dt===void 0)continue;let et=dt.buffer,xt=dt.type,St=dt.bytesPerElement,Pt=xt===i.INT||xt===i.UNSIGNED_INT||tt.gpuType===sh;if(tt.isInterleavedBufferAttribute){let Tt=tt.data,Yt=Tt.isInterleavedBuffer===!0?Tt.stride:Tt.itemSize,ce=tt.offset;if(Tt.isInstancedInterleavedBuffer||Tt.isInstancedBufferAttribute){for(let qt=0;qt<j.locationSize;qt++)m(j.location+qt,Tt.meshPerAttribute);N.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=Tt.meshPerAttribute*Tt.count)}else for(let qt=0;qt<j.locationSize;qt++)p(j.location+qt);i.bindBuffer(i.ARRAY_BUFFER,et);for(let qt=0;qt<j.locationSize;qt++)C(j.location+qt,pt/j.locationSize,xt,rt,Yt*St,(ce+pt/j.locationSize*qt)*St,Pt)}else{if(tt.isInstancedBufferAttribute){for(let Tt=0;Tt<j.locationSize;Tt++)m(j.location+Tt,tt.meshPerAttribute);N.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=tt.meshPerAttribute*tt.count)}else for(let Tt=0;Tt<j.locationSize;Tt++)p(j.location+Tt);i.bindBuffer(i.ARRAY_BUFFER,et);for(let Tt=0;Tt<j.locationSize;Tt++)C(j.location+Tt,pt/j.locationSize,xt,rt,pt*St,pt/j.locationSize*Tt*St,Pt)}}else if(H!==void 0){let rt=H[ht];if(rt!==void 0)switch(rt.length){case 2:i.vertexAttrib2fv(j.location,rt);break;case 3:i.vertexAttrib3fv(j.location,rt);break;case 4:i.vertexAttrib4fv(j.location,rt);break;default:i.vertexAttrib1fv(j.location,rt)}}}}v()}function P(){k();for(let N in n){let z=n[N];for(let W in z){let D=z[W];for(let X in D){let Z=D[X];for(let H in Z)h(Z[H].object),delete Z[H];delete D[X]}}delete n[N]}}function A(N){if(n[N.id]===void 0)return;let z=n[N.id];for(let W in z){let D=z[W];for(let X in D){let Z=D[X];for(let H in Z)h(Z[H].object),delete Z[H];delete D[X]}}delete n[N.id]}function x(N){for(let z in n){let W=n[z];for(let D in W){let X=W[D];if(X[N.id]===void 0)continue;let Z=X[N.id];for(let H in Z)h(Z[H].object),delete Z[H];delete X[N.id]}}}function T(N){for(let z in n){let W=n[z],D=N.isInstancedMesh===!0?N.id:0,X=W[D];if(X!==void 0){for(let Z in X){let H=X[Z];for(let ht in H)h(H[ht].object),delete H[ht];delete X[Z]}delete W[D],Object.keys(W).length===0&&delete n[z]}}}function k(){U(),o=!0,r!==s&&(r=s,c(r.object))}function U(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:k,resetDefaultState:U,dispose:P,releaseStatesOfGeometry:A,releaseStatesOfObject:T,releaseStatesOfProgram:x,initAttributes:y,enableAttribute:p,disableUnusedAttributes:v}}function Iw(i,t,e){let n;function s(l){n=l}function r(l,c){i.drawArrays(n,l,c),e.update(c,n,1)}function o(l,c,h){h!==0&&(i.drawArraysInstanced(n,l,c,h),e.update(c,n,h))}function a(l,c,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,h);let f=0;for(let d=0;d<h;d++)f+=c[d];e.update(f,n,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function Lw(i,t,e,n){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let x=t.get("EXT_texture_filter_anisotropic");s=i.getParameter(x.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(x){return!(x!==Vi&&n.convert(x)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(x){let T=x===zi&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(x!==ai&&x!==ki&&!T&&n.convert(x)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(x){if(x==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";x="mediump"}return x==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",h=l(c);h!==c&&(jt("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let u=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),f=e.logarithmicDepthBuffer===!0&&u===!1;e.reversedDepthBuffer===!0&&u===!1&&jt("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&u===!0&&jt("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let d=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),g=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),y=i.getParameter(i.MAX_TEXTURE_SIZE),p=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),m=i.getParameter(i.MAX_VERTEX_ATTRIBS),v=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),C=i.getParameter(i.MAX_VARYING_VECTORS),b=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),P=i.getParameter(i.MAX_SAMPLES),A=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:f,reversedDepthBuffer:u,maxTextures:d,maxVertexTextures:g,maxTextureSize:y,maxCubemapSize:p,maxAttributes:m,maxVertexUniforms:v,maxVaryings:C,maxFragmentUniforms:b,maxSamples:P,samples:A}}function Dw(i){let t=this,e=null,n=0,s=!1,r=!1,o=new mi,a=new oe,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,f){let d=u.length!==0||f||n!==0||s;return s=f,n=u.length,d},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,f){e=h(u,f,0)},this.setState=function(u,f,d){let g=u.clippingPlanes,y=u.clipIntersection,p=u.clipShadows,m=i.get(u);if(!s||g===null||g.length===0||r&&!p)r?h(null):c();else{let v=r?0:n,C=v*4,b=m.clippingState||null;l.value=b,b=h(g,f,C,d);for(let P=0;P!==C;++P)b[P]=e[P];m.clippingState=b,this.numIntersection=y?this.numPlanes:0,this.numPlanes+=v}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=n>0),t.numPlanes=n,t.numIntersection=0}function h(u,f,d,g){let y=u!==null?u.length:0,p=null;if(y!==0){if(p=l.value,g!==!0||p===null){let m=d+y*4,v=f.matrixWorldInverse;a.getNormalMatrix(v),(p===null||p.length<m)&&(p=new Float32Array(m));for(let C=0,b=d;C!==y;++C,b+=4)o.copy(u[C]).applyMatrix4(v,a),o.normal.toArray(p,b),p[b+3]=o.constant}l.value=p,l.needsUpdate=!0}return t.numPlanes=y,t.numIntersection=0,p}}var Ja=class extends gi{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let n={width:t,height:t,depth:1},s=[n,n,n,n,n,n];this.texture=new wa(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new _i(5,5,5),r=new os({name:"CubemapFromEquirect",uniforms:br(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:ni,blending:yr});r.uniforms.tEquirect.value=e;let o=new bn(s,r),a=e.minFilter;return e.minFilter===Cs&&(e.minFilter=Qn),new Mo(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,n=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,n,s);t.setRenderTarget(r)}},c0=256,Nw=3,Uw=20,L0=256,D0=16,Fw=3,Ow=new G,Bw=new ue,Wh=class i{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Mo(1,10,null),this._boxMesh=new bn(new _i(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,n=.1,s=100,r={}){let{size:o=256,position:a=Ow}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),h=this._getSourceTarget(!0);e>0&&(h.texture.mipmapsAutoUpdate=!1);let u=l.autoClear,f=l.autoClearColor,d=l.autoClearDepth,g=l.autoClearStencil,y=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,y===null&&(t.background=l.getClearColor(Bw));let p=new Mo(n,s,h);return p.position.copy(a),p.update(l,t),l.autoClear=u,l.autoClearColor=f,l.autoClearDepth=d,l.autoClearStencil=g,t.background=y,e>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=f0(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=u0(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(c0,nd(t))}_fromTexture(t,e){t.mapping===Sr||t.mapping===Eo?this._setSize(t.image.length===0?c0:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let n=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(n),n}_allocateTarget(){let t=this._cubeSize,e=h0(t,!1,!1),n=Math.log2(t)-Nw;for(let s=0;s<=n;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==e||t&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=h0(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===Sr||t.mapping===Eo?(this._cubemapMaterial===null&&(this._cubemapMaterial=f0()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=u0()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=kw(),this._integrationMaterial=zw());let e=this._cubeSize,n=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/D0);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-Fw)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let l=a>0?Math.log2(e)+.5*Math.log2(6/(L0*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=Vw());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,n),s.envMap.value=t.texture,this._renderCube(r,0,n)}};function h0(i,t,e){return new Ja(i,{minFilter:Cs,generateMipmaps:t,type:zi,colorSpace:da,depthBuffer:e})}function Ka(i,t,e){return new os({name:i,uniforms:t,vertexShader:me.cube_vert,fragmentShader:e,side:ni,blending:yr,depthTest:!1,depthWrite:!1})}function kw(){return Ka("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${L0}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function zw(){return Ka("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:D0}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function Vw(){return Ka("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${Uw}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function u0(){return Ka("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function f0(){return Ka("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function Gw(i){let t=new WeakMap,e=new WeakMap,n=null;function s(f,d=!1){return f==null?null:d?o(f):r(f)}function r(f){if(f&&f.isTexture){let d=f.mapping;if(d===eh||d===nh)if(t.has(f)){let g=t.get(f).texture;return a(g,f.mapping)}else{let g=f.image;if(g&&g.height>0){let y=new Ja(g.height);return y.fromEquirectangularTexture(i,f),t.set(f,y),f.addEventListener("dispose",c),a(y.texture,f.mapping)}else return null}}return f}function o(f){if(f&&f.isTexture&&f.isPMREMTexture!==!0){let d=f.mapping,g=d===eh||d===nh,y=d===Sr||d===Eo;if(g||y){let p=e.get(f),m=p!==void 0?p.texture.pmremVersion:0;if(f.isRenderTargetTexture&&f.pmremVersion!==m)return n===null&&(n=new Wh(i)),p=g?n.fromEquirectangular(f,p):n.fromCubemap(f,p),p.texture.pmremVersion=f.pmremVersion,e.set(f,p),p.texture;if(p!==void 0)return p.texture;{let v=f.image;return g&&v&&v.height>0||y&&v&&l(v)?(n===null&&(n=new Wh(i)),p=g?n.fromEquirectangular(f):n.fromCubemap(f),p.texture.pmremVersion=f.pmremVersion,e.set(f,p),f.addEventListener("dispose",h),p.texture):null}}}return f}function a(f,d){return d===eh?f.mapping=Sr:d===nh&&(f.mapping=Eo),f}function l(f){let d=0,g=6;for(let y=0;y<g;y++)f[y]!==void 0&&d++;return d===g}function c(f){let d=f.target;d.removeEventListener("dispose",c);let g=t.get(d);g!==void 0&&(t.delete(d),g.dispose())}function h(f){let d=f.target;d.removeEventListener("dispose",h);let g=e.get(d);g!==void 0&&(e.delete(d),g.dispose())}function u(){t=new WeakMap,e=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:u}}function Hw(i){let t={};function e(n){if(t[n]!==void 0)return t[n];let s=i.getExtension(n);return t[n]=s,s}return{has:function(n){return e(n)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(n){let s=e(n);return s===null&&ha("WebGLRenderer: "+n+" extension not supported."),s}}}function Ww(i,t,e,n){let s={},r=new WeakMap,o=new FinalizationRegistry(g=>delete s[g]);function a(g){l(g.target)}function l(g){g.index!==null&&t.remove(g.index);for(let p in g.attributes)t.remove(g.attributes[p]);g.removeEventListener("dispose",a),delete s[g.id],o.unregister(g);let y=r.get(g);y&&(t.remove(y),r.delete(g)),n.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,e.memory.geometries--}function c(g,y){return s[y.id]!==void 0||(y.addEventListener("dispose",a),s[y.id]=new WeakRef(y),o.register(y,y.id,y),e.memory.geometries++),y}function h(g){let y=g.attributes;for(let p in y)t.update(y[p],i.ARRAY_BUFFER)}function u(g){let y=g.index,p=g.attributes.position,m=0;if(p===void 0)return;let v=y!==null?y.array.length:p.array.length/3-1,C=p.count>=65535?Sa:va,b=new C(Math.ceil(v/3)*6,1),P=b.array;if(y!==null){let x=y.array;m=y.version;for(let T=0,k=0;T<v;T+=3){let U=x[T+0],N=x[T+1],z=x[T+2];P[k++]=U,P[k++]=N,P[k++]=N,P[k++]=z,P[k++]=z,P[k++]=U}}else{m=p.version;for(let x=0,T=0;x<v;x+=3){let k=x+0,U=x+1,N=x+2;P[T++]=k,P[T++]=U,P[T++]=U,P[T++]=N,P[T++]=N,P[T++]=k}}b.version=m;let A=r.get(g);A&&t.remove(A),r.set(g,b)}function f(g){let y=r.get(g);if(y){let p=g.index;p!==null&&y.version<p.version&&u(g)}else u(g);return r.get(g)}function d(){for(let g in s){let y=s[g].deref();y!==void 0&&l(y)}}return{get:c,update:h,getWireframeAttribute:f,dispose:d}}function Xw(i,t,e){let n;function s(u){n=u}let r,o;function a(u){r=u.type,o=u.bytesPerElement}function l(u,f){i.drawElements(n,f,r,u*o),e.update(f,n,1)}function c(u,f,d){d!==0&&(i.drawElementsInstanced(n,f,r,u*o,d),e.update(f,n,d))}function h(u,f,d){if(d===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,f,0,r,u,0,d);let y=0;for(let p=0;p<d;p++)y+=f[p];e.update(y,n,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function qw(i){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(e.calls++,o){case i.TRIANGLES:e.triangles+=a*(r/3);break;case i.LINES:e.lines+=a*(r/2);break;case i.LINE_STRIP:e.lines+=a*(r-1);break;case i.LINE_LOOP:e.lines+=a*r;break;case i.POINTS:e.points+=a*r;break;default:se("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:n}}function $w(i,t,e){let n=new WeakMap,s=new Qe;function r(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0,f=n.get(a);if(f===void 0||f.count!==u){let k=function(){x.dispose(),n.delete(a),a.removeEventListener("dispose",k)};f!==void 0&&f.texture.dispose();let d=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,y=a.morphAttributes.color!==void 0,p=a.morphAttributes.position||[],m=a.morphAttributes.normal||[],v=a.morphAttributes.color||[],C=0;d===!0&&(C=1),g===!0&&(C=2),y===!0&&(C=3);let b=a.attributes.position.count*C,P=1;b>t.maxTextureSize&&(P=Math.ceil(b/t.maxTextureSize),b=t.maxTextureSize);let A=new Float32Array(b*P*4*u),x=new _a(A,b,P,u);x.type=ki,x.needsUpdate=!0;let T=C*4;for(let U=0;U<u;U++){let N=p[U],z=m[U],W=v[U],D=b*P*4*U;for(let X=0;X<N.count;X++){let Z=X*T;d===!0&&(s.fromBufferAttribute(N,X),A[D+Z+0]=s.x,A[D+Z+1]=s.y,A[D+Z+2]=s.z,A[D+Z+3]=0),g===!0&&(s.fromBufferAttribute(z,X),A[D+Z+4]=s.x,A[D+Z+5]=s.y,A[D+Z+6]=s.z,A[D+Z+7]=0),y===!0&&(s.fromBufferAttribute(W,X),A[D+Z+8]=s.x,A[D+Z+9]=s.y,A[D+Z+10]=s.z,A[D+Z+11]=W.itemSize===4?s.w:1)}}f={count:u,texture:x,size:new Jt(b,P)},n.set(a,f),a.addEventListener("dispose",k)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,e);else{let d=0;for(let y=0;y<c.length;y++)d+=c[y];let g=a.morphTargetsRelative?1:1-d;l.getUniforms().setValue(i,"morphTargetBaseInfluence",g),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",f.texture,e),l.getUniforms().setValue(i,"morphTargetsTextureSize",f.size)}return{update:r}}function Yw(i,t,e,n,s){let r=new WeakMap;function o(c){let h=s.render.frame,u=c.geometry,f=t.get(c,u);if(r.get(f)!==h&&(t.update(f),r.set(f,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(e.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,i.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let d=c.skeleton;r.get(d)!==h&&(d.update(),r.set(d,h))}return f}function a(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),n.releaseStatesOfObject(h),e.remove(h.instanceMatrix),h.instanceColor!==null&&e.remove(h.instanceColor)}return{update:o,dispose:a}}var Zw={[Uf]:"LINEAR_TONE_MAPPING",[Ff]:"REINHARD_TONE_MAPPING",[Of]:"CINEON_TONE_MAPPING",[Bf]:"ACES_FILMIC_TONE_MAPPING",[zf]:"AGX_TONE_MAPPING",[Vf]:"NEUTRAL_TONE_MAPPING",[kf]:"CUSTOM_TONE_MAPPING"};function Jw(i,t,e,n,s,r){let o=new gi(t,e,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,h=new an;h.setAttribute("position",new Re([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new Re([0,2,0,0,2,0],2));let u=new zc({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),f=new bn(h,u),d=new Ua(-1,1,1,-1,0,1),g=null,y=null,p=!1,m,v=null,C=[],b=!1;this.setSize=function(P,A){o.setSize(P,A),a!==null&&a.setSize(P,A),l!==null&&l.setSize(P,A);for(let x=0;x<C.length;x++){let T=C[x];T.setSize&&T.setSize(P,A)}},this.setEffects=function(P){C=P,b=C.length>0&&C[0].isRenderPass===!0;let A=o.width,x=o.height;C.length>0&&a===null&&(a=new gi(A,x,{type:zi,depthBuffer:!1,stencilBuffer:!1}),l=new gi(A,x,{type:zi,depthBuffer:!1,stencilBuffer:!1}));let T=s===!0&&C.some(k=>k.needsDepthTexture===!0);T!==(o.depthTexture!==null)&&(T===!0&&c===null&&(c=new As(A,x),r===!0&&(c.format=Rs,c.type=Mr)),o.dispose(),o.depthTexture=T?c:null,o.resolveDepthBuffer=T,o.storeMultisampledDepthBuffer=T);for(let k=0;k<C.length;k++){let U=C[k];U.setSize&&U.setSize(A,x),T&&U.needsDepthTexture===!0&&U.setDepthTexture&&U.setDepthTexture(c)}},this.begin=function(P,A){if(p||P.toneMapping===ls&&C.length===0)return!1;if(v=A,A!==null){let x=A.width,T=A.height;(o.width!==x||o.height!==T)&&this.setSize(x,T)}return b===!1&&P.setRenderTarget(o),m=P.toneMapping,P.toneMapping=ls,!0},this.hasRenderPass=function(){return b},this.end=function(P,A){P.toneMapping=m,p=!0;let x=o,T=a;for(let k=0;k<C.length;k++){let U=C[k];U.enabled!==!1&&(U.render(P,T,x,A),U.needsSwap!==!1&&(x=T,T=T===a?l:a))}if(g!==P.outputColorSpace||y!==P.toneMapping){g=P.outputColorSpace,y=P.toneMapping,u.defines={},Me.getTransfer(g)===Le&&(u.defines.SRGB_TRANSFER="");let k=Zw[y];k&&(u.defines[k]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=x.texture,P.setRenderTarget(v),P.render(f,d),v=null,p=!1},this.isCompositing=function(){return p},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),h.dispose(),u.dispose()}}var N0=new ei,U0=new As(1,1),F0=new Ea(1),O0=new _a,B0=new Nc,k0=new wa,d0=[],p0=[],m0=new Float32Array(16),g0=new Float32Array(9),_0=new Float32Array(4);function Ro(i,t,e){let n=i[0];if(n<=0||n>0)return i;let s=t*e,r=d0[s];if(r===void 0&&(r=new Float32Array(s),d0[s]=r),t!==0){n.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,i[o].toArray(r,a)}return r}function wn(i,t){if(i.length!==t.length)return!1;for(let e=0,n=i.length;e<n;e++)if(i[e]!==t[e])return!1;return!0}function Tn(i,t){for(let e=0,n=t.length;e<n;e++)i[e]=t[e]}function qh(i,t){let e=p0[t];e===void 0&&(e=new Int32Array(t),p0[t]=e);for(let n=0;n!==t;++n)e[n]=i.allocateTextureUnit();return e}function Kw(i,t){let e=this.cache;e[0]!==t&&(i.uniform1f(this.addr,t),e[0]=t)}function jw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(wn(e,t))return;i.uniform2fv(this.addr,t),Tn(e,t)}}function Qw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(i.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(wn(e,t))return;i.uniform3fv(this.addr,t),Tn(e,t)}}function tT(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(wn(e,t))return;i.uniform4fv(this.addr,t),Tn(e,t)}}function eT(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(wn(e,t))return;i.uniformMatrix2fv(this.addr,!1,t),Tn(e,t)}else{if(wn(e,n))return;_0.set(n),i.uniformMatrix2fv(this.addr,!1,_0),Tn(e,n)}}function nT(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(wn(e,t))return;i.uniformMatrix3fv(this.addr,!1,t),Tn(e,t)}else{if(wn(e,n))return;g0.set(n),i.uniformMatrix3fv(this.addr,!1,g0),Tn(e,n)}}function iT(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(wn(e,t))return;i.uniformMatrix4fv(this.addr,!1,t),Tn(e,t)}else{if(wn(e,n))return;m0.set(n),i.uniformMatrix4fv(this.addr,!1,m0),Tn(e,n)}}function sT(i,t){let e=this.cache;e[0]!==t&&(i.uniform1i(this.addr,t),e[0]=t)}function rT(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(wn(e,t))return;i.uniform2iv(this.addr,t),Tn(e,t)}}function oT(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(wn(e,t))return;i.uniform3iv(this.addr,t),Tn(e,t)}}function aT(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(wn(e,t))return;i.uniform4iv(this.addr,t),Tn(e,t)}}function lT(i,t){let e=this.cache;e[0]!==t&&(i.uniform1ui(this.addr,t),e[0]=t)}function cT(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(wn(e,t))return;i.uniform2uiv(this.addr,t),Tn(e,t)}}function hT(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(wn(e,t))return;i.uniform3uiv(this.addr,t),Tn(e,t)}}function uT(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(wn(e,t))return;i.uniform4uiv(this.addr,t),Tn(e,t)}}function $h(i){return i.version===0&&(i.compareFunction=jf,i.needsUpdate=!0),i}function fT(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=$h(U0):r=N0,e.setTexture2D(t||r,s)}function dT(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture3D(t||B0,s)}function pT(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=$h(F0):r=k0,e.setTextureCube(t||r,s)}function mT(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture2DArray(t||O0,s)}function gT(i){switch(i){case 5126:return Kw;case 35664:return jw;case 35665:return Qw;case 35666:return tT;case 35674:return eT;case 35675:return nT;case 35676:return iT;case 5124:case 35670:return sT;case 35667:case 35671:return rT;case 35668:case 35672:return oT;case 35669:case 35673:return aT;case 5125:return lT;case 36294:return cT;case 36295:return hT;case 36296:return uT;case 35678:case 36198:case 36298:case 36306:case 35682:return fT;case 35679:case 36299:case 36307:return dT;case 35680:case 36300:case 36308:case 36293:return pT;case 36289:case 36303:case 36311:case 36292:return mT}}function _T(i,t){i.uniform1fv(this.addr,t)}function xT(i,t){let e=Ro(t,this.size,2);i.uniform2fv(this.addr,e)}function yT(i,t){let e=Ro(t,this.size,3);i.uniform3fv(this.addr,e)}function vT(i,t){let e=Ro(t,this.size,4);i.uniform4fv(this.addr,e)}function ST(i,t){let e=Ro(t,this.size,4);i.uniformMatrix2fv(this.addr,!1,e)}function MT(i,t){let e=Ro(t,this.size,9);i.uniformMatrix3fv(this.addr,!1,e)}function bT(i,t){let e=Ro(t,this.size,16);i.uniformMatrix4fv(this.addr,!1,e)}function wT(i,t){i.uniform1iv(this.addr,t)}function TT(i,t){i.uniform2iv(this.addr,t)}function ET(i,t){i.uniform3iv(this.addr,t)}function AT(i,t){i.uniform4iv(this.addr,t)}function CT(i,t){i.uniform1uiv(this.addr,t)}function RT(i,t){i.uniform2uiv(this.addr,t)}function PT(i,t){i.uniform3uiv(this.addr,t)}function IT(i,t){i.uniform4uiv(this.addr,t)}function LT(i,t,e){let n=this.cache,s=t.length,r=qh(e,s);wn(n,r)||(i.uniform1iv(this.addr,r),Tn(n,r));let o;this.type===i.SAMPLER_2D_SHADOW?o=$h(U0):o=N0;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function DT(i,t,e){let n=this.cache,s=t.length,r=qh(e,s);wn(n,r)||(i.uniform1iv(this.addr,r),Tn(n,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||B0,r[o])}function NT(i,t,e){let n=this.cache,s=t.length,r=qh(e,s);wn(n,r)||(i.uniform1iv(this.addr,r),Tn(n,r));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=$h(F0):o=k0;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function UT(i,t,e){let n=this.cache,s=t.length,r=qh(e,s);wn(n,r)||(i.uniform1iv(this.addr,r),Tn(n,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||O0,r[o])}function FT(i){switch(i){case 5126:return _T;case 35664:return xT;case 35665:return yT;case 35666:return vT;case 35674:return ST;case 35675:return MT;case 35676:return bT;case 5124:case 35670:return wT;case 35667:case 35671:return TT;case 35668:case 35672:return ET;case 35669:case 35673:return AT;case 5125:return CT;case 36294:return RT;case 36295:return PT;case 36296:return IT;case 35678:case 36198:case 36298:case 36306:case 35682:return LT;case 35679:case 36299:case 36307:return DT;case 35680:case 36300:case 36308:case 36293:return NT;case 36289:case 36303:case 36311:case 36292:return UT}}var fd=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.setValue=gT(e.type)}},dd=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=FT(e.type)}},pd=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],n)}}},hd=/(\w+)(\])?(\[|\.)?/g;function x0(i,t){i.seq.push(t),i.map[t.id]=t}function OT(i,t,e){let n=i.name,s=n.length;for(hd.lastIndex=0;;){let r=hd.exec(n),o=hd.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){x0(e,c===void 0?new fd(a,i,t):new dd(a,i,t));break}else{let u=e.map[a];u===void 0&&(u=new pd(a),x0(e,u)),e=u}}}var Co=class{constructor(t,e){this.seq=[],this.map={};let n=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=t.getActiveUniform(e,o),l=t.getUniformLocation(e,a.name);OT(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,n,s){let r=this.map[e];r!==void 0&&r.setValue(t,n,s)}setOptional(t,e,n){let s=e[n];s!==void 0&&this.setValue(t,n,s)}static upload(t,e,n,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let n=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&n.push(o)}return n}};function y0(i,t,e){let n=i.createShader(t);return i.shaderSource(n,e),i.compileShader(n),n}var BT=37297,kT=0;function zT(i,t){let e=i.split(`
`),n=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return n.join(`
`)}var v0=new oe;function VT(i){Me._getMatrix(v0,Me.workingColorSpace,i);let t=`mat3( ${v0.elements.map(e=>e.toFixed(4))} )`;switch(Me.getTransfer(i)){case pa:return[t,"LinearTransferOETF"];case Le:return[t,"sRGBTransferOETF"];default:return jt("WebGLProgram: Unsupported color space: ",i),[t,"LinearTransferOETF"]}}function S0(i,t,e){let n=i.getShaderParameter(t,i.COMPILE_STATUS),r=(i.getShaderInfoLog(t)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+zT(i.getShaderSource(t),a)}else return r}function GT(i,t){let e=VT(t);return[`vec4 ${i}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var HT={[Uf]:"Linear",[Ff]:"Reinhard",[Of]:"Cineon",[Bf]:"ACESFilmic",[zf]:"AgX",[Vf]:"Neutral",[kf]:"Custom"};function WT(i,t){let e=HT[t];return e===void 0?(jt("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var Hh=new G;function XT(){Me.getLuminanceCoefficients(Hh);let i=Hh.x.toFixed(4),t=Hh.y.toFixed(4),e=Hh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function qT(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Za).join(`
`)}function $T(i){let t=[];for(let e in i){let n=i[e];n!==!1&&t.push("#define "+e+" "+n)}return t.join(`
`)}function YT(i,t){let e={},n=i.getProgramParameter(t,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(t,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:i.getAttribLocation(t,o),locationSize:a}}return e}function Za(i){return i!==""}function M0(i,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function b0(i,t){return i.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var ZT=/^[ \t]*#include +<([\w\d./]+)>/gm;function md(i){return i.replace(ZT,JT)}function JT(i,t){let e=me[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return md(e)}var KT=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function w0(i){return i.replace(KT,jT)}function jT(i,t,e,n){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function T0(i){let t=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?t+=`
#define HIGH_PRECISION`:i.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}var QT={[za]:"SHADOWMAP_TYPE_PCF",[wo]:"SHADOWMAP_TYPE_VSM"};function tE(i){return QT[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var eE={[Eo]:"ENVMAP_MODE_REFRACTION"};function nE(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":eE[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var iE={[Nf]:"ENVMAP_BLENDING_MULTIPLY",[Hg]:"ENVMAP_BLENDING_MIX",[Wg]:"ENVMAP_BLENDING_ADD"};function sE(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":iE[i.combine]||"ENVMAP_BLENDING_NONE"}function rE(i,t,e,n){let s=i.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=tE(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=nE(e),u=sE(e),f=qT(e),d=$T(r),g=s.createProgram(),y,p,m=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(y=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d].filter(Za).join(`
`),y.length>0&&(y+=`
`),p=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d].filter(Za).join(`
`),p.length>0&&(p+=`
`)):(y=[T0(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+h:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Za).join(`
`),p=[T0(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+h:"",e.envMap?"#define "+u:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==ls?"#define TONE_MAPPING":"",e.toneMapping!==ls?me.tonemapping_pars_fragment:"",e.toneMapping!==ls?WT("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",me.colorspace_pars_fragment,GT("linearToOutputTexel",e.outputColorSpace),XT(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Za).join(`
`)),o=md(o),o=M0(o,e),o=b0(o,e),a=md(a),a=M0(a,e),a=b0(a,e),o=w0(o),a=w0(a),e.isRawShaderMaterial!==!0&&(m=`#version 300 es
`,y=[f,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+y,p=["#define varying in",e.glslVersion===td?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===td?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);let v=m+y+o,C=m+p+a,b=y0(s,s.VERTEX_SHADER,v),P=y0(s,s.FRAGMENT_SHADER,C);s.attachShader(g,b),s.attachShader(g,P),e.index0AttributeName!==void 0?s.bindAttribLocation(g,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(g,0,"position"),s.linkProgram(g);function A(U){if(i.debug.checkShaderErrors){let N=s.getProgramInfoLog(g)||"",z=s.getShaderInfoLog(b)||"",W=s.getShaderInfoLog(P)||"",D=N.trim(),X=z.trim(),Z=W.trim(),H=!0,ht=!0;if(s.getProgramParameter(g,s.LINK_STATUS)===!1)if(H=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,g,b,P);else{let j=S0(s,b,"vertex"),tt=S0(s,P,"fragment");se("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(g,s.VALIDATE_STATUS)+`

Material Name: `+U.name+`
Material Type: `+U.type+`

Program Info Log: `+D+`
`+j+`
`+tt)}else D!==""?jt("WebGLProgram: Program Info Log:",D):(X===""||Z==="")&&(ht=!1);ht&&(U.diagnostics={runnable:H,programLog:D,vertexShader:{log:X,prefix:y},fragmentShader:{log:Z,prefix:p}})}s.deleteShader(b),s.deleteShader(P),x=new Co(s,g),T=YT(s,g)}let x;this.getUniforms=function(){return x===void 0&&A(this),x};let T;this.getAttributes=function(){return T===void 0&&A(this),T};let k=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return k===!1&&(k=s.getProgramParameter(g,BT)),k},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(g),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=kT++,this.cacheKey=t,this.usedTimes=1,this.program=g,this.vertexShader=b,this.fragmentShader=P,this}var oE=0,gd=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,n){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let n of e)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,n=e.get(t);return n===void 0&&(n=new Set,e.set(t,n)),n}_getShaderStage(t){let e=this.shaderCache,n=e.get(t);return n===void 0&&(n=new _d(t),e.set(t,n)),n}},_d=class{constructor(t){this.id=oE++,this.code=t,this.usedTimes=0}};function aE(i){return i===er||i===qa||i===$a}function lE(i,t,e,n,s,r){let o=new xa,a=new gd,l=new Set,c=[],h=new Map,u=n.logarithmicDepthBuffer,f={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function d(x){return l.add(x),x===0?"uv":`uv${x}`}function g(x,T,k,U,N,z){let W=U.fog,D=N.geometry,X=x.isMeshStandardMaterial||x.isMeshLambertMaterial||x.isMeshPhongMaterial?U.environment:null,Z=x.isMeshStandardMaterial||x.isMeshLambertMaterial&&!x.envMap||x.isMeshPhongMaterial&&!x.envMap,H=t.get(x.envMap||X,Z),ht=f[x.type],j=n.precision;x.precision!==null&&(j=n.getMaxPrecision(x.precision),j!==x.precision&&jt("WebGLProgram.getParameters:",x.precision,"not supported, using",j,"instead."));let tt=D.morphAttributes.position||D.morphAttributes.normal||D.morphAttributes.color,rt=tt!==void 0?tt.length:0,pt=0;D.morphAttributes.position!==void 0&&(pt=1),D.morphAttributes.normal!==void 0&&(pt=2),D.morphAttributes.color!==void 0&&(pt=3);let dt,et,xt,St;if(ht){let It=hs[ht];dt=It.vertexShader,et=It.fragmentShader}else{dt=x.vertexShader,et=x.fragmentShader;let It=a.getVertexShaderStage(x),fe=a.getFragmentShaderStage(x);a.update(x,It,fe),xt=It.id,St=fe.id}let Pt=i.getRenderTarget(),Tt=i.state.buffers.depth.getReversed(),Yt=N.isInstancedMesh===!0,ce=N.isBatchedMesh===!0,qt=!!x.map,ge=!!x.matcap,de=!!H,ae=de&&H.isPMREMTexture===!0,Ke=!!x.aoMap,He=!!x.lightMap,un=!!x.bumpMap&&x.wireframe===!1,Be=!!x.normalMap,Rn=!!x.displacementMap,we=!!x.emissiveMap,yn=!!x.metalnessMap,en=!!x.roughnessMap,fn=x.anisotropy>0,O=x.clearcoat>0,Lt=x.diffuseRoughness>0,Qt=x.dispersion>0,he=x.retroreflectivity>0,Et=x.iridescence>0,ze=x.sheen>0,Wt=x.transmission>0,Kt=fn&&!!x.anisotropyMap,R=O&&!!x.clearcoatMap,S=O&&!!x.clearcoatNormalMap,q=O&&!!x.clearcoatRoughnessMap,ft=Lt&&!!x.diffuseRoughnessMap,at=Et&&!!x.iridescenceMap,vt=Et&&!!x.iridescenceThicknessMap,Mt=ze&&!!x.sheenColorMap,nt=ze&&!!x.sheenRoughnessMap,st=!!x.specularMap,gt=!!x.specularColorMap,F=!!x.specularIntensityMap,ot=Wt&&!!x.transmissionMap,it=Wt&&!!x.thicknessMap,At=!!x.gradientMap,yt=!!x.alphaMap,wt=x.alphaTest>0,$t=!!x.alphaHash,ne=!!x.extensions,ct=ls;x.toneMapped&&(Pt===null||Pt.isXRRenderTarget===!0)&&(ct=i.toneMapping);let zt=ae?H.isCompressedCubeTexture?H.image[0].mipmaps:H.mipmaps:null,ie={shaderID:ht,shaderType:x.type,shaderName:x.name,vertexShader:dt,fragmentShader:et,defines:x.defines,customVertexShaderID:xt,customFragmentShaderID:St,isRawShaderMaterial:x.isRawShaderMaterial===!0,glslVersion:x.glslVersion,precision:j,batching:ce,batchingColor:ce&&N._colorsTexture!==null,instancing:Yt,instancingColor:Yt&&N.instanceColor!==null,instancingMorph:Yt&&N.morphTexture!==null,outputColorSpace:Pt===null?i.outputColorSpace:Pt.isXRRenderTarget===!0?Pt.texture.colorSpace:Me.workingColorSpace,alphaToCoverage:!!x.alphaToCoverage,map:qt,matcap:ge,envMap:de,envMapMode:de&&H.mapping,envMapPMREM:ae,envMapMaxLod:ae?zt.length-1:null,envMapSize:ae?zt[0].width:null,aoMap:Ke,lightMap:He,bumpMap:un,normalMap:Be,displacementMap:Rn,emissiveMap:we,normalMapObjectSpace:Be&&x.normalMapType===$g,normalMapTangentSpace:Be&&x.normalMapType===zh,packedNormalMap:Be&&x.normalMapType===zh&&aE(x.normalMap.format),metalnessMap:yn,roughnessMap:en,anisotropy:fn,anisotropyMap:Kt,clearcoat:O,clearcoatMap:R,clearcoatNormalMap:S,clearcoatRoughnessMap:q,diffuseRoughness:Lt,diffuseRoughnessMap:ft,dispersion:Qt,retroreflection:he,iridescence:Et,iridescenceMap:at,iridescenceThicknessMap:vt,sheen:ze,sheenColorMap:Mt,sheenRoughnessMap:nt,specularMap:st,specularColorMap:gt,specularIntensityMap:F,transmission:Wt,transmissionMap:ot,thicknessMap:it,gradientMap:At,opaque:x.transparent===!1&&x.blending===To&&x.alphaToCoverage===!1,alphaMap:yt,alphaTest:wt,alphaHash:$t,combine:x.combine,mapUv:qt&&d(x.map.channel),aoMapUv:Ke&&d(x.aoMap.channel),lightMapUv:He&&d(x.lightMap.channel),bumpMapUv:un&&d(x.bumpMap.channel),normalMapUv:Be&&d(x.normalMap.channel),displacementMapUv:Rn&&d(x.displacementMap.channel),emissiveMapUv:we&&d(x.emissiveMap.channel),metalnessMapUv:yn&&d(x.metalnessMap.channel),roughnessMapUv:en&&d(x.roughnessMap.channel),anisotropyMapUv:Kt&&d(x.anisotropyMap.channel),clearcoatMapUv:R&&d(x.clearcoatMap.channel),clearcoatNormalMapUv:S&&d(x.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:q&&d(x.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ft&&d(x.diffuseRoughnessMap.channel),iridescenceMapUv:at&&d(x.iridescenceMap.channel),iridescenceThicknessMapUv:vt&&d(x.iridescenceThicknessMap.channel),sheenColorMapUv:Mt&&d(x.sheenColorMap.channel),sheenRoughnessMapUv:nt&&d(x.sheenRoughnessMap.channel),specularMapUv:st&&d(x.specularMap.channel),specularColorMapUv:gt&&d(x.specularColorMap.channel),specularIntensityMapUv:F&&d(x.specularIntensityMap.channel),transmissionMapUv:ot&&d(x.transmissionMap.channel),thicknessMapUv:it&&d(x.thicknessMap.channel),alphaMapUv:yt&&d(x.alphaMap.channel),vertexTangents:!!D.attributes.tangent&&(Be||fn),vertexNormals:!!D.attributes.normal,vertexColors:x.vertexColors,vertexAlphas:x.vertexColors===!0&&!!D.attributes.color&&D.attributes.color.itemSize===4,pointsUvs:N.isPoints===!0&&!!D.attributes.uv&&(qt||yt),fog:!!W,useFog:x.fog===!0,fogExp2:!!W&&W.isFogExp2,flatShading:x.wireframe===!1&&(x.flatShading===!0||D.attributes.normal===void 0&&Be===!1&&(x.isMeshLambertMaterial||x.isMeshPhongMaterial||x.isMeshStandardMaterial||x.isMeshPhysicalMaterial)),sizeAttenuation:x.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:Tt,skinning:N.isSkinnedMesh===!0,hasPositionAttribute:D.attributes.position!==void 0,morphTargets:D.morphAttributes.position!==void 0,morphNormals:D.morphAttributes.normal!==void 0,morphColors:D.morphAttributes.color!==void 0,morphTargetsCount:rt,morphTextureStride:pt,numSunLights:T.sun.length,numDirLights:T.directional.length,numPointLights:T.point.length,numSpotLights:T.spot.length,numSpotLightMaps:T.spotLightMap.length,numRectAreaLights:T.rectArea.length,numHemiLights:T.hemi.length,numSunLightShadows:T.sunShadowMap.length,numDirLightShadows:T.directionalShadowMap.length,numPointLightShadows:T.pointShadowMap.length,numSpotLightShadows:T.spotShadowMap.length,numSpotLightShadowsWithMaps:T.numSpotLightShadowsWithMaps,numLightProbes:T.numLightProbes,numLightProbeGrids:z.filter(It=>It.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:x.dithering,shadowMapEnabled:i.shadowMap.enabled&&k.length>0,shadowMapType:i.shadowMap.type,toneMapping:ct,decodeVideoTexture:qt&&x.map.isVideoTexture===!0&&Me.getTransfer(x.map.colorSpace)===Le,decodeVideoTextureEmissive:we&&x.emissiveMap.isVideoTexture===!0&&Me.getTransfer(x.emissiveMap.colorSpace)===Le,premultipliedAlpha:x.premultipliedAlpha,doubleSided:x.side===oi,flipSided:x.side===ni,useDepthPacking:x.depthPacking>=0,depthPacking:x.depthPacking||0,index0AttributeName:x.index0AttributeName,extensionClipCullDistance:ne&&x.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(ne&&x.extensions.multiDraw===!0||ce)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:x.customProgramCacheKey()};return ie.vertexUv1s=l.has(1),ie.vertexUv2s=l.has(2),ie.vertexUv3s=l.has(3),l.clear(),ie}function y(x){let T=[];if(x.shaderID?T.push(x.shaderID):(T.push(x.customVertexShaderID),T.push(x.customFragmentShaderID)),x.defines!==void 0)for(let k in x.defines)T.push(k),T.push(x.defines[k]);return x.isRawShaderMaterial===!1&&(p(T,x),m(T,x),T.push(i.outputColorSpace)),T.push(x.customProgramCacheKey),T.join()}function p(x,T){x.push(T.precision),x.push(T.outputColorSpace),x.push(T.envMapMode),x.push(T.envMapPMREM),x.push(T.envMapMaxLod),x.push(T.envMapSize),x.push(T.mapUv),x.push(T.alphaMapUv),x.push(T.lightMapUv),x.push(T.aoMapUv),x.push(T.bumpMapUv),x.push(T.normalMapUv),x.push(T.displacementMapUv),x.push(T.emissiveMapUv),x.push(T.metalnessMapUv),x.push(T.roughnessMapUv),x.push(T.anisotropyMapUv),x.push(T.clearcoatMapUv),x.push(T.clearcoatNormalMapUv),x.push(T.clearcoatRoughnessMapUv),x.push(T.diffuseRoughnessMapUv),x.push(T.iridescenceMapUv),x.push(T.iridescenceThicknessMapUv),x.push(T.sheenColorMapUv),x.push(T.sheenRoughnessMapUv),x.push(T.specularMapUv),x.push(T.specularColorMapUv),x.push(T.specularIntensityMapUv),x.push(T.transmissionMapUv),x.push(T.thicknessMapUv),x.push(T.combine),x.push(T.fogExp2),x.push(T.sizeAttenuation),x.push(T.morphTargetsCount),x.push(T.numSunLights),x.push(T.numDirLights),x.push(T.numPointLights),x.push(T.numSpotLights),x.push(T.numSpotLightMaps),x.push(T.numHemiLights),x.push(T.numRectAreaLights),x.push(T.numSunLightShadows),x.push(T.numDirLightShadows),x.push(T.numPointLightShadows),x.push(T.numSpotLightShadows),x.push(T.numSpotLightShadowsWithMaps),x.push(T.numLightProbes),x.push(T.numLightProbeGrids),x.push(T.shadowMapType),x.push(T.toneMapping),x.push(T.numClippingPlanes),x.push(T.numClipIntersection),x.push(T.depthPacking)}function m(x,T){o.disableAll(),T.instancing&&o.enable(0),T.instancingColor&&o.enable(1),T.instancingMorph&&o.enable(2),T.matcap&&o.enable(3),T.envMap&&o.enable(4),T.normalMapObjectSpace&&o.enable(5),T.normalMapTangentSpace&&o.enable(6),T.clearcoat&&o.enable(7),T.iridescence&&o.enable(8),T.alphaTest&&o.enable(9),T.vertexColors&&o.enable(10),T.vertexAlphas&&o.enable(11),T.vertexUv1s&&o.enable(12),T.vertexUv2s&&o.enable(13),T.vertexUv3s&&o.enable(14),T.vertexTangents&&o.enable(15),T.anisotropy&&o.enable(16),T.alphaHash&&o.enable(17),T.batching&&o.enable(18),T.dispersion&&o.enable(19),T.retroreflection&&o.enable(24),T.diffuseRoughness&&o.enable(25),T.batchingColor&&o.enable(20),T.gradientMap&&o.enable(21),T.packedNormalMap&&o.enable(22),T.vertexNormals&&o.enable(23),x.push(o.mask),o.disableAll(),T.fog&&o.enable(0),T.useFog&&o.enable(1),T.flatShading&&o.enable(2),T.logarithmicDepthBuffer&&o.enable(3),T.reversedDepthBuffer&&o.enable(4),T.skinning&&o.enable(5),T.morphTargets&&o.enable(6),T.morphNormals&&o.enable(7),T.morphColors&&o.enable(8),T.premultipliedAlpha&&o.enable(9),T.shadowMapEnabled&&o.enable(10),T.doubleSided&&o.enable(11),T.flipSided&&o.enable(12),T.useDepthPacking&&o.enable(13),T.dithering&&o.enable(14),T.transmission&&o.enable(15),T.sheen&&o.enable(16),T.opaque&&o.enable(17),T.pointsUvs&&o.enable(18),T.decodeVideoTexture&&o.enable(19),T.decodeVideoTextureEmissive&&o.enable(20),T.alphaToCoverage&&o.enable(21),T.numLightProbeGrids>0&&o.enable(22),T.hasPositionAttribute&&o.enable(23),x.push(o.mask)}function v(x){let T=f[x.type],k;if(T){let U=hs[T];k=o0.clone(U.uniforms)}else k=x.uniforms;return k}function C(x,T){let k=h.get(T);return k!==void 0?++k.usedTimes:(k=new rE(i,T,x,s),c.push(k),h.set(T,k)),k}function b(x){if(--x.usedTimes===0){let T=c.indexOf(x);c[T]=c[c.length-1],c.pop(),h.delete(x.cacheKey),x.destroy()}}function P(x){a.remove(x)}function A(){a.dispose()}return{getParameters:g,getProgramCacheKey:y,getUniforms:v,acquireProgram:C,releaseProgram:b,releaseShaderCache:P,programs:c,dispose:A}}function cE(){let i=new WeakMap;function t(o){return i.has(o)}function e(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:t,get:e,remove:n,update:s,dispose:r}}function hE(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.material.id!==t.material.id?i.material.id-t.material.id:i.materialVariant!==t.materialVariant?i.materialVariant-t.materialVariant:i.z!==t.z?i.z-t.z:i.id-t.id}function E0(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.z!==t.z?t.z-i.z:i.id-t.id}function A0(){let i=[],t=0,e=[],n=[],s=[];function r(){t=0,e.length=0,n.length=0,s.length=0}function o(f){let d=0;return f.isInstancedMesh&&(d+=2),f.isSkinnedMesh&&(d+=1),d}function a(f,d,g,y,p,m){let v=i[t];return v===void 0?(v={id:f.id,object:f,geometry:d,material:g,materialVariant:o(f),groupOrder:y,renderOrder:f.renderOrder,z:p,group:m},i[t]=v):(v.id=f.id,v.object=f,v.geometry=d,v.material=g,v.materialVariant=o(f),v.groupOrder=y,v.renderOrder=f.renderOrder,v.z=p,v.group=m),t++,v}function l(f,d,g,y,p,m,v){v.reversedDepth===!0&&(p=-p);let C=a(f,d,g,y,p,m);g.transmission>0?n.push(C):g.transparent===!0?s.push(C):e.push(C)}function c(f,d,g,y,p,m){let v=a(f,d,g,y,p,m);g.transmission>0?n.unshift(v):g.transparent===!0?s.unshift(v):e.unshift(v)}function h(f,d){e.length>1&&e.sort(f||hE),n.length>1&&n.sort(d||E0),s.length>1&&s.sort(d||E0)}function u(){for(let f=t,d=i.length;f<d;f++){let g=i[f];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:e,transmissive:n,transparent:s,init:r,push:l,unshift:c,finish:u,sort:h}}function uE(){let i=new WeakMap;function t(n,s){let r=i.get(n),o;return r===void 0?(o=new A0,i.set(n,[o])):s>=r.length?(o=new A0,r.push(o)):o=r[s],o}function e(){i=new WeakMap}return{get:t,dispose:e}}function fE(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new G,color:new ue};break;case"SpotLight":e={position:new G,direction:new G,color:new ue,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new G,color:new ue,distance:0,decay:0};break;case"HemisphereLight":e={direction:new G,skyColor:new ue,groundColor:new ue};break;case"RectAreaLight":e={color:new ue,position:new G,halfWidth:new G,halfHeight:new G};break}return i[t.id]=e,e}}}function dE(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Jt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Jt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Jt,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[t.id]=e,e}}}var pE=0;function mE(i,t){return(t.castShadow?2:0)-(i.castShadow?2:0)+(t.map?1:0)-(i.map?1:0)}function gE(i){let t=new fE,e=dE(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new G);let s=new G,r=new De,o=new De;function a(c){let h=0,u=0,f=0;for(let z=0;z<9;z++)n.probe[z].set(0,0,0);let d=0,g=0,y=0,p=0,m=0,v=0,C=0,b=0,P=0,A=0,x=0,T=0,k=0,U=0;c.sort(mE);for(let z=0,W=c.length;z<W;z++){let D=c[z],X=D.color,Z=D.intensity,H=D.distance,ht=null;if(D.shadow&&D.shadow.map&&(D.shadow.map.texture.format===er?ht=D.shadow.map.texture:ht=D.shadow.map.depthTexture||D.shadow.map.texture),D.isAmbientLight)h+=X.r*Z,u+=X.g*Z,f+=X.b*Z;else if(D.isLightProbe){for(let j=0;j<9;j++)n.probe[j].addScaledVector(D.sh.coefficients[j],Z);U++}else if(D.isSunLight){let j=t.get(D);if(j.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){let tt=D.shadow,rt=e.get(D);rt.shadowIntensity=tt.intensity,rt.shadowBias=tt.bias,rt.shadowNormalBias=tt.normalBias,rt.shadowRadius=tt.radius,rt.shadowMapSize.copy(tt.mapSize).multiply(tt.getFrameExtents()),n.sunShadow[g]=rt,n.sunShadowMap[g]=ht;let pt=tt.getViewportCount();for(let dt=0;dt<pt;dt++)n.sunShadowMatrix[y+dt]=tt.getMatrix(dt),n.sunShadowCascade[y+dt]=tt._cascadeData[dt];y+=pt,g++}n.sun[d]=j,d++}else if(D.isDirectionalLight){let j=t.get(D);if(j.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){let tt=D.shadow,rt=e.get(D);rt.shadowIntensity=tt.intensity,rt.shadowBias=tt.bias,rt.shadowNormalBias=tt.normalBias,rt.shadowRadius=tt.radius,rt.shadowMapSize=tt.mapSize,n.directionalShadow[p]=rt,n.directionalShadowMap[p]=ht,n.directionalShadowMatrix[p]=D.shadow.matrix,P++}n.directional[p]=j,p++}else if(D.isSpotLight){let j=t.get(D);j.position.setFromMatrixPosition(D.matrixWorld),j.color.copy(X).multiplyScalar(Z),j.distance=H,j.coneCos=Math.cos(D.angle),j.penumbraCos=Math.cos(D.angle*(1-D.penumbra)),j.decay=D.decay,n.spot[v]=j;let tt=D.shadow;if(D.map&&(n.spotLightMap[T]=D.map,T++,tt.updateMatrices(D),D.castShadow&&k++),n.spotLightMatrix[v]=tt.matrix,D.castShadow){let rt=e.get(D);rt.shadowIntensity=tt.intensity,rt.shadowBias=tt.bias,rt.shadowNormalBias=tt.normalBias,rt.shadowRadius=tt.radius,rt.shadowMapSize=tt.mapSize,n.spotShadow[v]=rt,n.spotShadowMap[v]=ht,x++}v++}else if(D.isRectAreaLight){let j=t.get(D);j.color.copy(X).multiplyScalar(Z),j.halfWidth.set(D.width*.5,0,0),j.halfHeight.set(0,D.height*.5,0),n.rectArea[C]=j,C++}else if(D.isPointLight){let j=t.get(D);if(j.color.copy(D.color).multiplyScalar(D.intensity),j.distance=D.distance,j.decay=D.decay,D.castShadow){let tt=D.shadow,rt=e.get(D);rt.shadowIntensity=tt.intensity,rt.shadowBias=tt.bias,rt.shadowNormalBias=tt.normalBias,rt.shadowRadius=tt.radius,rt.shadowMapSize=tt.mapSize,rt.shadowCameraNear=tt.camera.near,rt.shadowCameraFar=tt.camera.far,n.pointShadow[m]=rt,n.pointShadowMap[m]=ht,n.pointShadowMatrix[m]=D.shadow.matrix,A++}n.point[m]=j,m++}else if(D.isHemisphereLight){let j=t.get(D);j.skyColor.copy(D.color).multiplyScalar(Z),j.groundColor.copy(D.groundColor).multiplyScalar(Z),n.hemi[b]=j,b++}}C>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Ut.LTC_FLOAT_1,n.rectAreaLTC2=Ut.LTC_FLOAT_2):(n.rectAreaLTC1=Ut.LTC_HALF_1,n.rectAreaLTC2=Ut.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=u,n.ambient[2]=f;let N=n.hash;(N.sunLength!==d||N.directionalLength!==p||N.pointLength!==m||N.spotLength!==v||N.rectAreaLength!==C||N.hemiLength!==b||N.numSunShadows!==g||N.numDirectionalShadows!==P||N.numPointShadows!==A||N.numSpotShadows!==x||N.numSpotMaps!==T||N.numLightProbes!==U)&&(n.sun.length=d,n.directional.length=p,n.spot.length=v,n.rectArea.length=C,n.point.length=m,n.hemi.length=b,n.sunShadow.length=g,n.sunShadowMap.length=g,n.sunShadowMatrix.length=y,n.sunShadowCascade.length=y,n.directionalShadow.length=P,n.directionalShadowMap.length=P,n.directionalShadowMatrix.length=P,n.pointShadow.length=A,n.pointShadowMap.length=A,n.pointShadowMatrix.length=A,n.spotShadow.length=x,n.spotShadowMap.length=x,n.spotLightMatrix.length=x+T-k,n.spotLightMap.length=T,n.numSpotLightShadowsWithMaps=k,n.numLightProbes=U,N.sunLength=d,N.directionalLength=p,N.pointLength=m,N.spotLength=v,N.rectAreaLength=C,N.hemiLength=b,N.numSunShadows=g,N.numDirectionalShadows=P,N.numPointShadows=A,N.numSpotShadows=x,N.numSpotMaps=T,N.numLightProbes=U,n.version=pE++)}function l(c,h){let u=0,f=0,d=0,g=0,y=0,p=0,m=h.matrixWorldInverse;for(let v=0,C=c.length;v<C;v++){let b=c[v];if(b.isSunLight){let P=n.sun[u];P.direction.setFromMatrixPosition(b.matrixWorld),P.direction.transformDirection(m),u++}else if(b.isDirectionalLight){let P=n.directional[f];P.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),P.direction.sub(s),P.direction.transformDirection(m),f++}else if(b.isSpotLight){let P=n.spot[g];P.position.setFromMatrixPosition(b.matrixWorld),P.position.applyMatrix4(m),P.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),P.direction.sub(s),P.direction.transformDirection(m),g++}else if(b.isRectAreaLight){let P=n.rectArea[y];P.position.setFromMatrixPosition(b.matrixWorld),P.position.applyMatrix4(m),o.identity(),r.copy(b.matrixWorld),r.premultiply(m),o.extractRotation(r),P.halfWidth.set(b.width*.5,0,0),P.halfHeight.set(0,b.height*.5,0),P.halfWidth.applyMatrix4(o),P.halfHeight.applyMatrix4(o),y++}else if(b.isPointLight){let P=n.point[d];P.position.setFromMatrixPosition(b.matrixWorld),P.position.applyMatrix4(m),d++}else if(b.isHemisphereLight){let P=n.hemi[p];P.direction.setFromMatrixPosition(b.matrixWorld),P.direction.transformDirection(m),p++}}}return{setup:a,setupView:l,state:n}}function C0(i){let t=new gE(i),e=[],n=[],s=[];function r(u){h.camera=u,e.length=0,n.length=0,s.length=0}function o(u){u.isLightProbeGrid?s.push(u):e.push(u)}function a(u){n.push(u)}function l(){t.setup(e),s.sort((u,f)=>u.priority-f.priority||u.id-f.id)}function c(u){t.setupView(e,u)}let h={lightsArray:e,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function _E(i){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new C0(i),t.set(s,[a])):r>=o.length?(a=new C0(i),o.push(a)):a=o[r],a}function n(){t=new WeakMap}return{get:e,dispose:n}}var xE=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,yE=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,vE=[new G(1,0,0),new G(-1,0,0),new G(0,1,0),new G(0,-1,0),new G(0,0,1),new G(0,0,-1)],SE=[new G(0,-1,0),new G(0,-1,0),new G(0,0,1),new G(0,0,-1),new G(0,-1,0),new G(0,-1,0)],R0=new De,Ya=new G,ud=new G;function ME(i,t,e){let n=new Ys,s=new Jt,r=new Jt,o=new Qe,a=new Vc,l=new Gc,c={},h=e.maxTextureSize,u={[tr]:ni,[ni]:tr,[oi]:oi},f=new os({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Jt},radius:{value:4}},vertexShader:xE,fragmentShader:yE}),d=f.clone();d.defines.HORIZONTAL_PASS=1;let g=new an;g.setAttribute("position",new Fi(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let y=new bn(g,f),p=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=za;let m=this.type;this.render=function(A,x,T){if(p.enabled===!1||p.autoUpdate===!1&&p.needsUpdate===!1||A.length===0)return;this.type===wg&&(jt("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=za);let k=i.getRenderTarget(),U=i.getActiveCubeFace(),N=i.getActiveMipmapLevel(),z=i.state;z.setBlending(yr),z.buffers.depth.getReversed()===!0?z.buffers.color.setClear(0,0,0,0):z.buffers.color.setClear(1,1,1,1),z.buffers.depth.setTest(!0),z.setScissorTest(!1);let W=m!==this.type;W&&x.traverse(function(D){D.material&&(Array.isArray(D.material)?D.material.forEach(X=>X.needsUpdate=!0):D.material.needsUpdate=!0)});for(let D=0,X=A.length;D<X;D++){let Z=A[D],H=Z.shadow;if(H===void 0){jt("WebGLShadowMap:",Z,"has no shadow.");continue}if(H.autoUpdate===!1&&H.needsUpdate===!1)continue;s.copy(H.mapSize);let ht=H.getFrameExtents();s.multiply(ht),r.copy(H.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/ht.x),s.x=r.x*ht.x,H.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/ht.y),s.y=r.y*ht.y,H.mapSize.y=r.y));let j=i.state.buffers.depth.getReversed();if(H.camera._reversedDepth=j,H.map===null||W===!0){if(H.map!==null&&(H.map.depthTexture!==null&&(H.map.depthTexture.dispose(),H.map.depthTexture=null),H.map.dispose()),this.type===wo){if(Z.isPointLight){jt("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}H.map=new gi(s.x,s.y,{format:er,type:zi,minFilter:Qn,magFilter:Qn,generateMipmaps:!1}),H.map.texture.name=Z.name+".shadowMap",H.map.depthTexture=new As(s.x,s.y,ki),H.map.depthTexture.name=Z.name+".shadowMapDepth",H.map.depthTexture.format=Ts,H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=Un,H.map.depthTexture.magFilter=Un}else Z.isPointLight?(H.map=new Ja(s.x),H.map.depthTexture=new Ea(s.x,Bi)):(H.map=new gi(s.x,s.y),H.map.depthTexture=new As(s.x,s.y,Bi)),H.map.depthTexture.name=Z.name+".shadowMap",H.map.depthTexture.format=Ts,this.type===za?(H.map.depthTexture.compareFunction=j?Kf:Jf,H.map.depthTexture.minFilter=Qn,H.map.depthTexture.magFilter=Qn):(H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=Un,H.map.depthTexture.magFilter=Un);H.camera.updateProjectionMatrix()}H.map.isWebGLCubeRenderTarget!==!0&&(H.map.width!==s.x||H.map.height!==s.y)&&H.map.setSize(s.x,s.y);let tt=H.map.isWebGLCubeRenderTarget?6:H.getViewportCount();Z.isPointLight!==!0&&H.updateMatrices(Z,T);let rt=(H.camera.layers.mask&4294967294)!==0?H.camera.layers:T.layers;for(let pt=0;pt<tt;pt++){let dt=H.getCamera(pt);if(Z.isPointLight){let et=H.camera,xt=H.matrix,St=Z.distance||et.far;St!==et.far&&(et.far=St,et.updateProjectionMatrix()),Ya.setFromMatrixPosition(Z.matrixWorld),et.position.copy(Ya),ud.copy(et.position),ud.add(vE[pt]),et.up.copy(SE[pt]),et.lookAt(ud),et.updateMatrixWorld(),xt.makeTranslation(-Ya.x,-Ya.y,-Ya.z),R0.multiplyMatrices(et.projectionMatrix,et.matrixWorldInverse),H._frustum.setFromProjectionMatrix(R0,et.coordinateSystem,et.reversedDepth)}if(H.map.isWebGLCubeRenderTarget)i.setRenderTarget(H.map,pt),i.clear();else{pt===0&&(i.setRenderTarget(H.map),i.clear());let et=H.getViewport(pt);o.set(r.x*et.x,r.y*et.y,r.x*et.z,r.y*et.w),z.viewport(o)}n=H.getFrustum(pt),b(x,T,dt,Z,rt,this.type)}H.isPointLightShadow!==!0&&this.type===wo&&v(H,T),H.needsUpdate=!1}m=this.type,p.needsUpdate=!1,i.setRenderTarget(k,U,N)};function v(A,x){let T=t.update(y);f.defines.VSM_SAMPLES!==A.blurSamples&&(f.defines.VSM_SAMPLES=A.blurSamples,d.defines.VSM_SAMPLES=A.blurSamples,f.needsUpdate=!0,d.needsUpdate=!0),A.mapPass===null?A.mapPass=new gi(s.x,s.y,{format:er,type:zi}):(A.mapPass.width!==A.map.width||A.mapPass.height!==A.map.height)&&A.mapPass.setSize(A.map.width,A.map.height),f.uniforms.shadow_pass.value=A.map.depthTexture,f.uniforms.resolution.value.set(A.map.width,A.map.height),f.uniforms.radius.value=A.radius,i.setRenderTarget(A.mapPass),i.clear(),i.renderBufferDirect(x,null,T,f,y,null),d.uniforms.shadow_pass.value=A.mapPass.texture,d.uniforms.resolution.value.set(A.map.width,A.map.height),d.uniforms.radius.value=A.radius,i.setRenderTarget(A.map),i.clear(),i.renderBufferDirect(x,null,T,d,y,null)}function C(A,x,T,k){let U=null,N=T.isPointLight===!0?A.customDistanceMaterial:A.customDepthMaterial;if(N!==void 0)U=N;else if(U=T.isPointLight===!0?l:a,i.localClippingEnabled&&x.clipShadows===!0&&Array.isArray(x.clippingPlanes)&&x.clippingPlanes.length!==0||x.displacementMap&&x.displacementScale!==0||x.alphaMap&&x.alphaTest>0||x.map&&x.alphaTest>0||x.alphaToCoverage===!0){let z=U.uuid,W=x.uuid,D=c[z];D===void 0&&(D={},c[z]=D);let X=D[W];X===void 0&&(X=U.clone(),D[W]=X,x.addEventListener("dispose",P)),U=X}if(U.visible=x.visible,U.wireframe=x.wireframe,k===wo?U.side=x.shadowSide!==null?x.shadowSide:x.side:U.side=x.shadowSide!==null?x.shadowSide:u[x.side],U.alphaMap=x.alphaMap,U.alphaTest=x.alphaToCoverage===!0?.5:x.alphaTest,U.map=x.map,U.clipShadows=x.clipShadows,U.clippingPlanes=x.clippingPlanes,U.clipIntersection=x.clipIntersection,U.displacementMap=x.displacementMap,U.displacementScale=x.displacementScale,U.displacementBias=x.displacementBias,U.wireframeLinewidth=x.wireframeLinewidth,U.linewidth=x.linewidth,T.isPointLight===!0&&U.isMeshDistanceMaterial===!0){let z=i.properties.get(U);z.light=T}return U}function b(A,x,T,k,U,N){if(A.visible===!1)return;if(A.layers.test(U)&&(A.isMesh||A.isLine||A.isPoints)&&(A.castShadow||A.receiveShadow&&N===wo)&&(!A.frustumCulled||A.intersectsFrustum(n))){A.modelViewMatrix.multiplyMatrices(T.matrixWorldInverse,A.matrixWorld);let D=t.update(A),X=A.material;if(Array.isArray(X)){let Z=D.groups;for(let H=0,ht=Z.length;H<ht;H++){let j=Z[H],tt=X[j.materialIndex];if(tt&&tt.visible){let rt=C(A,tt,k,N);A.onBeforeShadow(i,A,x,T,D,rt,j),i.renderBufferDirect(T,null,D,rt,A,j),A.onAfterShadow(i,A,x,T,D,rt,j)}}}else if(X.visible){let Z=C(A,X,k,N);A.onBeforeShadow(i,A,x,T,D,Z,null),i.renderBufferDirect(T,null,D,Z,A,null),A.onAfterShadow(i,A,x,T,D,Z,null)}}let W=A.children;for(let D=0,X=W.length;D<X;D++)b(W[D],x,T,k,U,N)}function P(A){A.target.removeEventListener("dispose",P);for(let T in c){let k=c[T],U=A.target.uuid;U in k&&(k[U].dispose(),delete k[U])}}}function bE(i,t){function e(){let F=!1,ot=new Qe,it=null,At=new Qe(0,0,0,0);return{setMask:function(yt){it!==yt&&!F&&(i.colorMask(yt,yt,yt,yt),it=yt)},setLocked:function(yt){F=yt},setClear:function(yt,wt,$t,ne,ct){ct===!0&&(yt*=ne,wt*=ne,$t*=ne),ot.set(yt,wt,$t,ne),At.equals(ot)===!1&&(i.clearColor(yt,wt,$t,ne),At.copy(ot))},reset:function(){F=!1,it=null,At.set(-1,0,0,0)}}}function n(){let F=!1,ot=!1,it=null,At=null,yt=null;return{setReversed:function(wt){if(ot!==wt){let $t=t.get("EXT_clip_control");wt?$t.clipControlEXT($t.LOWER_LEFT_EXT,$t.ZERO_TO_ONE_EXT):$t.clipControlEXT($t.LOWER_LEFT_EXT,$t.NEGATIVE_ONE_TO_ONE_EXT),ot=wt;let ne=yt;yt=null,this.setClear(ne)}},getReversed:function(){return ot},setTest:function(wt){wt?Tt(i.DEPTH_TEST):Yt(i.DEPTH_TEST)},setMask:function(wt){it!==wt&&!F&&(i.depthMask(wt),it=wt)},setFunc:function(wt){if(ot&&(wt=i0[wt]),At!==wt){switch(wt){case Mc:i.depthFunc(i.NEVER);break;case bc:i.depthFunc(i.ALWAYS);break;case wc:i.depthFunc(i.LESS);break;case fo:i.depthFunc(i.LEQUAL);break;case Tc:i.depthFunc(i.EQUAL);break;case Ec:i.depthFunc(i.GEQUAL);break;case Ac:i.depthFunc(i.GREATER);break;case Cc:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}At=wt}},setLocked:function(wt){F=wt},setClear:function(wt){yt!==wt&&(yt=wt,ot&&(wt=1-wt),i.clearDepth(wt))},reset:function(){F=!1,it=null,At=null,yt=null,ot=!1}}}function s(){let F=!1,ot=null,it=null,At=null,yt=null,wt=null,$t=null,ne=null,ct=null;return{setTest:function(zt){F||(zt?Tt(i.STENCIL_TEST):Yt(i.STENCIL_TEST))},setMask:function(zt){ot!==zt&&!F&&(i.stencilMask(zt),ot=zt)},setFunc:function(zt,ie,It){(it!==zt||At!==ie||yt!==It)&&(i.stencilFunc(zt,ie,It),it=zt,At=ie,yt=It)},setOp:function(zt,ie,It){(wt!==zt||$t!==ie||ne!==It)&&(i.stencilOp(zt,ie,It),wt=zt,$t=ie,ne=It)},setLocked:function(zt){F=zt},setClear:function(zt){ct!==zt&&(i.clearStencil(zt),ct=zt)},reset:function(){F=!1,ot=null,it=null,At=null,yt=null,wt=null,$t=null,ne=null,ct=null}}}let r=new e,o=new n,a=new s,l={},c=new WeakMap,h={},u={},f={},d=new WeakMap,g=[],y=null,p=!1,m=null,v=null,C=null,b=null,P=null,A=null,x=null,T=new ue(0,0,0),k=0,U=!1,N=null,z=null,W=null,D=null,X=null,Z=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),H=!1,ht=0,j=i.getParameter(i.VERSION);j.indexOf("WebGL")!==-1?(ht=parseFloat(/^WebGL (\d)/.exec(j)[1]),H=ht>=1):j.indexOf("OpenGL ES")!==-1&&(ht=parseFloat(/^OpenGL ES (\d)/.exec(j)[1]),H=ht>=2);let tt=null,rt={},pt=i.getParameter(i.SCISSOR_BOX),dt=i.getParameter(i.VIEWPORT),et=new Qe().fromArray(pt),xt=new Qe().fromArray(dt);function St(F,ot,it,At){let yt=new Uint8Array(4),wt=i.createTexture();i.bindTexture(F,wt),i.texParameteri(F,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(F,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let $t=0;$t<it;$t++)F===i.TEXTURE_3D||F===i.TEXTURE_2D_ARRAY?i.texImage3D(ot,0,i.RGBA,1,1,At,0,i.RGBA,i.UNSIGNED_BYTE,yt):i.texImage2D(ot+$t,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,yt);return wt}let Pt={};Pt[i.TEXTURE_2D]=St(i.TEXTURE_2D,i.TEXTURE_2D,1),Pt[i.TEXTURE_CUBE_MAP]=St(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Pt[i.TEXTURE_2D_ARRAY]=St(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Pt[i.TEXTURE_3D]=St(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),Tt(i.DEPTH_TEST),o.setFunc(fo),un(!1),Be(Cf),Tt(i.CULL_FACE),Ke(yr);function Tt(F){h[F]!==!0&&(i.enable(F),h[F]=!0)}function Yt(F){h[F]!==!1&&(i.disable(F),h[F]=!1)}function ce(F,ot){return f[F]!==ot?(i.bindFramebuffer(F,ot),f[F]=ot,F===i.DRAW_FRAMEBUFFER&&(f[i.FRAMEBUFFER]=ot),F===i.FRAMEBUFFER&&(f[i.DRAW_FRAMEBUFFER]=ot),!0):!1}function qt(F,ot){let it=g,At=!1;if(F){it=d.get(ot),it===void 0&&(it=[],d.set(ot,it));let yt=F.textures;if(it.length!==yt.length||it[0]!==i.COLOR_ATTACHMENT0){for(let wt=0,$t=yt.length;wt<$t;wt++)it[wt]=i.COLOR_ATTACHMENT0+wt;it.length=yt.length,At=!0}}else it[0]!==i.BACK&&(it[0]=i.BACK,At=!0);At&&i.drawBuffers(it)}function ge(F){return y!==F?(i.useProgram(F),y=F,!0):!1}let de={[vr]:i.FUNC_ADD,[Eg]:i.FUNC_SUBTRACT,[Ag]:i.FUNC_REVERSE_SUBTRACT};de[Cg]=i.MIN,de[Rg]=i.MAX;let ae={[Pg]:i.ZERO,[Ig]:i.ONE,[Lg]:i.SRC_COLOR,[Lf]:i.SRC_ALPHA,[Bg]:i.SRC_ALPHA_SATURATE,[Fg]:i.DST_COLOR,[Ng]:i.DST_ALPHA,[Dg]:i.ONE_MINUS_SRC_COLOR,[Df]:i.ONE_MINUS_SRC_ALPHA,[Og]:i.ONE_MINUS_DST_COLOR,[Ug]:i.ONE_MINUS_DST_ALPHA,[kg]:i.CONSTANT_COLOR,[zg]:i.ONE_MINUS_CONSTANT_COLOR,[Vg]:i.CONSTANT_ALPHA,[Gg]:i.ONE_MINUS_CONSTANT_ALPHA};function Ke(F,ot,it,At,yt,wt,$t,ne,ct,zt){if(F===yr){p===!0&&(Yt(i.BLEND),p=!1);return}if(p===!1&&(Tt(i.BLEND),p=!0),F!==Tg){if(F!==m||zt!==U){if((v!==vr||P!==vr)&&(i.blendEquation(i.FUNC_ADD),v=vr,P=vr),zt)switch(F){case To:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Rf:i.blendFunc(i.ONE,i.ONE);break;case Pf:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case If:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:se("WebGLState: Invalid blending: ",F);break}else switch(F){case To:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Rf:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case Pf:se("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case If:se("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:se("WebGLState: Invalid blending: ",F);break}C=null,b=null,A=null,x=null,T.set(0,0,0),k=0,m=F,U=zt}return}yt=yt||ot,wt=wt||it,$t=$t||At,(ot!==v||yt!==P)&&(i.blendEquationSeparate(de[ot],de[yt]),v=ot,P=yt),(it!==C||At!==b||wt!==A||$t!==x)&&(i.blendFuncSeparate(ae[it],ae[At],ae[wt],ae[$t]),C=it,b=At,A=wt,x=$t),(ne.equals(T)===!1||ct!==k)&&(i.blendColor(ne.r,ne.g,ne.b,ct),T.copy(ne),k=ct),m=F,U=!1}function He(F,ot){F.side===oi?Yt(i.CULL_FACE):Tt(i.CULL_FACE);let it=F.side===ni;ot&&(it=!it),un(it),F.blending===To&&F.transparent===!1?Ke(yr):Ke(F.blending,F.blendEquation,F.blendSrc,F.blendDst,F.blendEquationAlpha,F.blendSrcAlpha,F.blendDstAlpha,F.blendColor,F.blendAlpha,F.premultipliedAlpha),o.setFunc(F.depthFunc),o.setTest(F.depthTest),o.setMask(F.depthWrite),r.setMask(F.colorWrite);let At=F.stencilWrite;a.setTest(At),At&&(a.setMask(F.stencilWriteMask),a.setFunc(F.stencilFunc,F.stencilRef,F.stencilFuncMask),a.setOp(F.stencilFail,F.stencilZFail,F.stencilZPass)),we(F.polygonOffset,F.polygonOffsetFactor,F.polygonOffsetUnits),F.alphaToCoverage===!0?Tt(i.SAMPLE_ALPHA_TO_COVERAGE):Yt(i.SAMPLE_ALPHA_TO_COVERAGE)}function un(F){N!==F&&(F?i.frontFace(i.CW):i.frontFace(i.CCW),N=F)}function Be(F){F!==Mg?(Tt(i.CULL_FACE),F!==z&&(F===Cf?i.cullFace(i.BACK):F===bg?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Yt(i.CULL_FACE),z=F}function Rn(F){F!==W&&(H&&i.lineWidth(F),W=F)}function we(F,ot,it){F?(Tt(i.POLYGON_OFFSET_FILL),(D!==ot||X!==it)&&(D=ot,X=it,o.getReversed()&&(ot=-ot,it=-it),i.polygonOffset(ot,it))):Yt(i.POLYGON_OFFSET_FILL)}function yn(F){F?Tt(i.SCISSOR_TEST):Yt(i.SCISSOR_TEST)}function en(F){F===void 0&&(F=i.TEXTURE0+Z-1),tt!==F&&(i.activeTexture(F),tt=F)}function fn(F,ot,it){it===void 0&&(tt===null?it=i.TEXTURE0+Z-1:it=tt);let At=rt[it];At===void 0&&(At={type:void 0,texture:void 0},rt[it]=At),(At.type!==F||At.texture!==ot)&&(tt!==it&&(i.activeTexture(it),tt=it),i.bindTexture(F,ot||Pt[F]),At.type=F,At.texture=ot)}function O(){let F=rt[tt];F!==void 0&&F.type!==void 0&&(i.bindTexture(F.type,null),F.type=void 0,F.texture=void 0)}function Lt(){try{i.compressedTexImage2D(...arguments)}catch(F){se("WebGLState:",F)}}function Qt(){try{i.compressedTexImage3D(...arguments)}catch(F){se("WebGLState:",F)}}function he(){try{i.texSubImage2D(...arguments)}catch(F){se("WebGLState:",F)}}function Et(){try{i.texSubImage3D(...arguments)}catch(F){se("WebGLState:",F)}}function ze(){try{i.compressedTexSubImage2D(...arguments)}catch(F){se("WebGLState:",F)}}function Wt(){try{i.compressedTexSubImage3D(...arguments)}catch(F){se("WebGLState:",F)}}function Kt(){try{i.texStorage2D(...arguments)}catch(F){se("WebGLState:",F)}}function R(){try{i.texStorage3D(...arguments)}catch(F){se("WebGLState:",F)}}function S(){try{i.texImage2D(...arguments)}catch(F){se("WebGLState:",F)}}function q(){try{i.texImage3D(...arguments)}catch(F){se("WebGLState:",F)}}function ft(F){return u[F]!==void 0?u[F]:i.getParameter(F)}function at(F,ot){u[F]!==ot&&(i.pixelStorei(F,ot),u[F]=ot)}function vt(F){et.equals(F)===!1&&(i.scissor(F.x,F.y,F.z,F.w),et.copy(F))}function Mt(F){xt.equals(F)===!1&&(i.viewport(F.x,F.y,F.z,F.w),xt.copy(F))}function nt(F,ot){let it=c.get(ot);it===void 0&&(it=new WeakMap,c.set(ot,it));let At=it.get(F);At===void 0&&(At=i.getUniformBlockIndex(ot,F.name),i.uniformBlockBinding(ot,At,At),it.set(F,At))}function st(F,ot,it){let yt=c.get(ot).get(F);l[yt]!==it&&(i.bindBufferBase(i.UNIFORM_BUFFER,yt,it),l[yt]=it)}function gt(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),h={},u={},tt=null,rt={},f={},l={},d=new WeakMap,g=[],y=null,p=!1,m=null,v=null,C=null,b=null,P=null,A=null,x=null,T=new ue(0,0,0),k=0,U=!1,N=null,z=null,W=null,D=null,X=null,et.set(0,0,i.canvas.width,i.canvas.height),xt.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:Tt,disable:Yt,bindFramebuffer:ce,drawBuffers:qt,useProgram:ge,setBlending:Ke,setMaterial:He,setFlipSided:un,setCullFace:Be,setLineWidth:Rn,setPolygonOffset:we,setScissorTest:yn,activeTexture:en,bindTexture:fn,unbindTexture:O,compressedTexImage2D:Lt,compressedTexImage3D:Qt,texImage2D:S,texImage3D:q,pixelStorei:at,getParameter:ft,updateUBOMapping:nt,uniformBlockBinding:st,texStorage2D:Kt,texStorage3D:R,texSubImage2D:he,texSubImage3D:Et,compressedTexSubImage2D:ze,compressedTexSubImage3D:Wt,scissor:vt,viewport:Mt,reset:gt}}function wE(i,t,e,n,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Jt,h=new WeakMap,u=new Set,f,d=new WeakMap,g=new Set,y=new FinalizationRegistry(R=>g.delete(R)),p=!1;try{p=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(R,S){return p?new OffscreenCanvas(R,S):ma("canvas")}function v(R,S,q){let ft=1,at=Kt(R);if((at.width>q||at.height>q)&&(ft=q/Math.max(at.width,at.height)),ft<1)if(typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&R instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&R instanceof ImageBitmap||typeof VideoFrame<"u"&&R instanceof VideoFrame){let vt=Math.floor(ft*at.width),Mt=Math.floor(ft*at.height);f===void 0&&(f=m(vt,Mt));let nt=S?m(vt,Mt):f;return nt.width=vt,nt.height=Mt,nt.getContext("2d").drawImage(R,0,0,vt,Mt),jt("WebGLRenderer: Texture has been resized from ("+at.width+"x"+at.height+") to ("+vt+"x"+Mt+")."),nt}else return"data"in R&&jt("WebGLRenderer: Image in DataTexture is too big ("+at.width+"x"+at.height+")."),R;return R}function C(R){return R.generateMipmaps}function b(R){i.generateMipmap(R)}function P(R){return R.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:R.isWebGL3DRenderTarget?i.TEXTURE_3D:R.isWebGLArrayRenderTarget||R.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function A(R,S,q,ft,at,vt=!1){if(R!==null){if(i[R]!==void 0)return i[R];jt("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+R+"'")}let Mt;ft&&(Mt=t.get("EXT_texture_norm16"),Mt||jt("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let nt=S;if(S===i.RED&&(q===i.FLOAT&&(nt=i.R32F),q===i.HALF_FLOAT&&(nt=i.R16F),q===i.UNSIGNED_BYTE&&(nt=i.R8),q===i.UNSIGNED_SHORT&&Mt&&(nt=Mt.R16_EXT),q===i.SHORT&&Mt&&(nt=Mt.R16_SNORM_EXT)),S===i.RED_INTEGER&&(q===i.UNSIGNED_BYTE&&(nt=i.R8UI),q===i.UNSIGNED_SHORT&&(nt=i.R16UI),q===i.UNSIGNED_INT&&(nt=i.R32UI),q===i.BYTE&&(nt=i.R8I),q===i.SHORT&&(nt=i.R16I),q===i.INT&&(nt=i.R32I)),S===i.RG&&(q===i.FLOAT&&(nt=i.RG32F),q===i.HALF_FLOAT&&(nt=i.RG16F),q===i.UNSIGNED_BYTE&&(nt=i.RG8),q===i.UNSIGNED_SHORT&&Mt&&(nt=Mt.RG16_EXT),q===i.SHORT&&Mt&&(nt=Mt.RG16_SNORM_EXT)),S===i.RG_INTEGER&&(q===i.UNSIGNED_BYTE&&(nt=i.RG8UI),q===i.UNSIGNED_SHORT&&(nt=i.RG16UI),q===i.UNSIGNED_INT&&(nt=i.RG32UI),q===i.BYTE&&(nt=i.RG8I),q===i.SHORT&&(nt=i.RG16I),q===i.INT&&(nt=i.RG32I)),S===i.RGB_INTEGER&&(q===i.UNSIGNED_BYTE&&(nt=i.RGB8UI),q===i.UNSIGNED_SHORT&&(nt=i.RGB16UI),q===i.UNSIGNED_INT&&(nt=i.RGB32UI),q===i.BYTE&&(nt=i.RGB8I),q===i.SHORT&&(nt=i.RGB16I),q===i.INT&&(nt=i.RGB32I)),S===i.RGBA_INTEGER&&(q===i.UNSIGNED_BYTE&&(nt=i.RGBA8UI),q===i.UNSIGNED_SHORT&&(nt=i.RGBA16UI),q===i.UNSIGNED_INT&&(nt=i.RGBA32UI),q===i.BYTE&&(nt=i.RGBA8I),q===i.SHORT&&(nt=i.RGBA16I),q===i.INT&&(nt=i.RGBA32I)),S===i.RGB&&(q===i.UNSIGNED_SHORT&&Mt&&(nt=Mt.RGB16_EXT),q===i.SHORT&&Mt&&(nt=Mt.RGB16_SNORM_EXT),q===i.UNSIGNED_INT_5_9_9_9_REV&&(nt=i.RGB9_E5),q===i.UNSIGNED_INT_10F_11F_11F_REV&&(nt=i.R11F_G11F_B10F)),S===i.RGBA){let st=vt?pa:Me.getTransfer(at);q===i.FLOAT&&(nt=i.RGBA32F),q===i.HALF_FLOAT&&(nt=i.RGBA16F),q===i.UNSIGNED_BYTE&&(nt=st===Le?i.SRGB8_ALPHA8:i.RGBA8),q===i.UNSIGNED_SHORT&&Mt&&(nt=Mt.RGBA16_EXT),q===i.SHORT&&Mt&&(nt=Mt.RGBA16_SNORM_EXT),q===i.UNSIGNED_SHORT_4_4_4_4&&(nt=i.RGBA4),q===i.UNSIGNED_SHORT_5_5_5_1&&(nt=i.RGB5_A1)}return(nt===i.R16F||nt===i.R32F||nt===i.RG16F||nt===i.RG32F||nt===i.RGBA16F||nt===i.RGBA32F)&&t.get("EXT_color_buffer_float"),nt}function x(R,S){let q;return R?S===null||S===Bi||S===Mr?q=i.DEPTH24_STENCIL8:S===ki?q=i.DEPTH32F_STENCIL8:S===Ao&&(q=i.DEPTH24_STENCIL8,jt("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):S===null||S===Bi||S===Mr?q=i.DEPTH_COMPONENT24:S===ki?q=i.DEPTH_COMPONENT32F:S===Ao&&(q=i.DEPTH_COMPONENT16),q}function T(R,S){return C(R)===!0||R.isFramebufferTexture&&R.minFilter!==Un&&R.minFilter!==Qn?Math.log2(Math.max(S.width,S.height))+1:R.mipmaps.length>0?R.mipmaps.length:R.isCompressedTexture&&Array.isArray(R.image)?S.mipmaps.length:1}function k(R){let S=new WeakRef(R);n.get(R).__ref=S,g.add(S),y.register(R,S,S)}function U(R){let S=n.get(R).__ref;S!==void 0&&(g.delete(S),y.unregister(S))}function N(R){W(R.target)}function z(R){D(R.target)}function W(R){R.removeEventListener("dispose",N),U(R),Z(R),R.isVideoTexture&&h.delete(R),R.isHTMLTexture&&u.delete(R)}function D(R){R.removeEventListener("dispose",z),U(R),ht(R)}function X(){for(let R of g){let S=R.deref();S!==void 0&&(S.isRenderTarget===!0?D(S):W(S))}g.clear(),u.clear()}function Z(R){let S=n.get(R);if(S.__webglInit===void 0)return;let q=R.source,ft=d.get(q);if(ft){let at=ft[S.__cacheKey];at.usedTimes--,at.usedTimes===0&&H(R),Object.keys(ft).length===0&&d.delete(q)}n.remove(R)}function H(R){let S=n.get(R);i.deleteTexture(S.__webglTexture);let q=R.source,ft=d.get(q);delete ft[S.__cacheKey],o.memory.textures--}function ht(R){let S=n.get(R);S.__depthDisposeCallback&&S.__depthDisposeCallback();let q=R.depthTexture;if(q&&q.renderTarget===R&&W(q),R.isWebGLCubeRenderTarget)for(let at=0;at<6;at++){if(Array.isArray(S.__webglFramebuffer[at]))for(let vt=0;vt<S.__webglFramebuffer[at].length;vt++)i.deleteFramebuffer(S.__webglFramebuffer[at][vt]);else i.deleteFramebuffer(S.__webglFramebuffer[at]);S.__webglDepthbuffer&&i.deleteRenderbuffer(S.__webglDepthbuffer[at])}else{if(Array.isArray(S.__webglFramebuffer))for(let at=0;at<S.__webglFramebuffer.length;at++)i.deleteFramebuffer(S.__webglFramebuffer[at]);else i.deleteFramebuffer(S.__webglFramebuffer);if(S.__webglDepthbuffer&&i.deleteRenderbuffer(S.__webglDepthbuffer),S.__webglMultisampledFramebuffer&&i.deleteFramebuffer(S.__webglMultisampledFramebuffer),S.__webglColorRenderbuffer)for(let at=0;at<S.__webglColorRenderbuffer.length;at++)S.__webglColorRenderbuffer[at]&&i.deleteRenderbuffer(S.__webglColorRenderbuffer[at]);S.__webglDepthRenderbuffer&&i.deleteRenderbuffer(S.__webglDepthRenderbuffer)}let ft=R.textures;for(let at=0,vt=ft.length;at<vt;at++){let Mt=n.get(ft[at]);Mt.__webglTexture&&(i.deleteTexture(Mt.__webglTexture),o.memory.textures--),n.remove(ft[at])}n.remove(R)}let j=0;function tt(){j=0}function rt(){return j}function pt(R){j=R}function dt(){let R=j;return R>=s.maxTextures&&jt("WebGLTextures: Trying to use "+(R+1)+" texture units while this GPU supports only "+s.maxTextures),j+=1,R}function et(R){let S=[];return S.push(R.wrapS),S.push(R.wrapT),S.push(R.wrapR||0),S.push(R.magFilter),S.push(R.minFilter),S.push(R.anisotropy),S.push(R.internalFormat),S.push(R.format),S.push(R.type),S.push(R.generateMipmaps),S.push(R.mipmapsAutoUpdate),S.push(R.premultiplyAlpha),S.push(R.flipY),S.push(R.unpackAlignment),S.push(R.colorSpace),S.join()}function xt(R,S){let q=n.get(R);if(R.isVideoTexture&&ze(R),R.isRenderTargetTexture===!1&&R.isExternalTexture!==!0&&R.version>0&&q.__version!==R.version){let ft=R.image;if(ft===null)jt("WebGLRenderer: Texture marked for update but no image data found.");else if(ft.complete===!1)jt("WebGLRenderer: Texture marked for update but image is incomplete");else{He(q,R,S);return}}else R.isExternalTexture&&(q.__webglTexture=R.sourceTexture?R.sourceTexture:null);e.bindTexture(i.TEXTURE_2D,q.__webglTexture,i.TEXTURE0+S)}function St(R,S){let q=n.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&q.__version!==R.version){He(q,R,S);return}else R.isExternalTexture&&(q.__webglTexture=R.sourceTexture?R.sourceTexture:null);e.bindTexture(i.TEXTURE_2D_ARRAY,q.__webglTexture,i.TEXTURE0+S)}function Pt(R,S){let q=n.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&q.__version!==R.version){He(q,R,S);return}e.bindTexture(i.TEXTURE_3D,q.__webglTexture,i.TEXTURE0+S)}function Tt(R,S){let q=n.get(R);if(R.version>0&&q.__version!==R.version){un(q,R,S);return}e.bindTexture(i.TEXTURE_CUBE_MAP,q.__webglTexture,i.TEXTURE0+S)}let Yt={[Rc]:i.REPEAT,[ns]:i.CLAMP_TO_EDGE,[Pc]:i.MIRRORED_REPEAT},ce={[Un]:i.NEAREST,[Xg]:i.NEAREST_MIPMAP_NEAREST,[Va]:i.NEAREST_MIPMAP_LINEAR,[Qn]:i.LINEAR,[ih]:i.LINEAR_MIPMAP_NEAREST,[Cs]:i.LINEAR_MIPMAP_LINEAR},qt={[Zg]:i.NEVER,[jf]:i.ALWAYS,[Jg]:i.LESS,[Jf]:i.LEQUAL,[Kg]:i.EQUAL,[Kf]:i.GEQUAL,[jg]:i.GREATER,[Qg]:i.NOTEQUAL};function ge(R,S){if(S.type===ki&&t.has("OES_texture_float_linear")===!1&&(S.magFilter===Qn||S.magFilter===ih||S.magFilter===Va||S.magFilter===Cs||S.minFilter===Qn||S.minFilter===ih||S.minFilter===Va||S.minFilter===Cs)&&jt("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(R,i.TEXTURE_WRAP_S,Yt[S.wrapS]),i.texParameteri(R,i.TEXTURE_WRAP_T,Yt[S.wrapT]),(R===i.TEXTURE_3D||R===i.TEXTURE_2D_ARRAY)&&i.texParameteri(R,i.TEXTURE_WRAP_R,Yt[S.wrapR]),i.texParameteri(R,i.TEXTURE_MAG_FILTER,ce[S.magFilter]),i.texParameteri(R,i.TEXTURE_MIN_FILTER,ce[S.minFilter]),S.compareFunction&&(i.texParameteri(R,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(R,i.TEXTURE_COMPARE_FUNC,qt[S.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(S.magFilter===Un||S.minFilter!==Va&&S.minFilter!==Cs||S.type===ki&&t.has("OES_texture_float_linear")===!1)return;if(S.anisotropy>1||n.get(S).__currentAnisotropy){let q=t.get("EXT_texture_filter_anisotropic");i.texParameterf(R,q.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(S.anisotropy,s.getMaxAnisotropy())),n.get(S).__currentAnisotropy=S.anisotropy}}}function de(R,S){let q=!1;R.__webglInit===void 0&&(R.__webglInit=!0,S.addEventListener("dispose",N),k(S));let ft=S.source,at=d.get(ft);at===void 0&&(at={},d.set(ft,at));let vt=et(S);if(vt!==R.__cacheKey){at[vt]===void 0&&(at[vt]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,q=!0),at[vt].usedTimes++;let Mt=at[R.__cacheKey];Mt!==void 0&&(at[R.__cacheKey].usedTimes--,Mt.usedTimes===0&&H(S)),R.__cacheKey=vt,R.__webglTexture=at[vt].texture}return q}function ae(R,S,q){return Math.floor(Math.floor(R/q)/S)}function Ke(R,S,q,ft){let vt=R.updateRanges;if(vt.length===0)e.texSubImage2D(i.TEXTURE_2D,0,0,0,S.width,S.height,q,ft,S.data);else{vt.sort((F,ot)=>F.start-ot.start);let Mt=0;for(let F=1;F<vt.length;F++){let ot=vt[Mt],it=vt[F],At=ot.start+ot.count,yt=ae(it.start,S.width,4),wt=ae(ot.start,S.width,4);it.start<=At+1&&yt===wt&&ae(it.start+it.count-1,S.width,4)===yt?ot.count=Math.max(ot.count,it.start+it.count-ot.start):(++Mt,vt[Mt]=it)}vt.length=Mt+1;let nt=e.getParameter(i.UNPACK_ROW_LENGTH),st=e.getParameter(i.UNPACK_SKIP_PIXELS),gt=e.getParameter(i.UNPACK_SKIP_ROWS);e.pixelStorei(i.UNPACK_ROW_LENGTH,S.width);for(let F=0,ot=vt.length;F<ot;F++){let it=vt[F],At=Math.floor(it.start/4),yt=Math.ceil(it.count/4),wt=At%S.width,$t=Math.floor(At/S.width),ne=yt,ct=1;e.pixelStorei(i.UNPACK_SKIP_PIXELS,wt),e.pixelStorei(i.UNPACK_SKIP_ROWS,$t),e.texSubImage2D(i.TEXTURE_2D,0,wt,$t,ne,ct,q,ft,S.data)}R.clearUpdateRanges(),e.pixelStorei(i.UNPACK_ROW_LENGTH,nt),e.pixelStorei(i.UNPACK_SKIP_PIXELS,st),e.pixelStorei(i.UNPACK_SKIP_ROWS,gt)}}function He(R,S,q){let ft=i.TEXTURE_2D;(S.isDataArrayTexture||S.isCompressedArrayTexture)&&(ft=i.TEXTURE_2D_ARRAY),S.isData3DTexture&&(ft=i.TEXTURE_3D);let at=de(R,S),vt=S.source;e.bindTexture(ft,R.__webglTexture,i.TEXTURE0+q);let Mt=n.get(vt);if(vt.version!==Mt.__version||at===!0){if(e.activeTexture(i.TEXTURE0+q),(typeof ImageBitmap<"u"&&S.image instanceof ImageBitmap)===!1){let ct=Me.getPrimaries(Me.workingColorSpace),zt=S.colorSpace===Ps?null:Me.getPrimaries(S.colorSpace),ie=S.colorSpace===Ps||ct===zt?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,S.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,ie)}e.pixelStorei(i.UNPACK_ALIGNMENT,S.unpackAlignment);let st=v(S.image,!1,s.maxTextureSize);st=Wt(S,st);let gt=r.convert(S.format,S.colorSpace),F=r.convert(S.type),ot=A(S.internalFormat,gt,F,S.normalized,S.colorSpace,S.isVideoTexture);ge(ft,S);let it,At=S.mipmaps,yt=S.isVideoTexture!==!0,wt=Mt.__version===void 0||at===!0,$t=vt.dataReady,ne=T(S,st);if(S.isDepthTexture)ot=x(S.format===Rs,S.type),wt&&(yt?e.texStorage2D(i.TEXTURE_2D,1,ot,st.width,st.height):e.texImage2D(i.TEXTURE_2D,0,ot,st.width,st.height,0,gt,F,null));else if(S.isDataTexture)if(At.length>0){yt&&wt&&e.texStorage2D(i.TEXTURE_2D,ne,ot,At[0].width,At[0].height);for(let ct=0,zt=At.length;ct<zt;ct++)it=At[ct],yt?$t&&e.texSubImage2D(i.TEXTURE_2D,ct,0,0,it.width,it.height,gt,F,it.data):e.texImage2D(i.TEXTURE_2D,ct,ot,it.width,it.height,0,gt,F,it.data);S.generateMipmaps=!1}else yt?(wt&&e.texStorage2D(i.TEXTURE_2D,ne,ot,st.width,st.height),$t&&Ke(S,st,gt,F)):e.texImage2D(i.TEXTURE_2D,0,ot,st.width,st.height,0,gt,F,st.data);else if(S.isCompressedTexture)if(S.isCompressedArrayTexture){yt&&wt&&e.texStorage3D(i.TEXTURE_2D_ARRAY,ne,ot,At[0].width,At[0].height,st.depth);for(let ct=0,zt=At.length;ct<zt;ct++)if(it=At[ct],S.format!==Vi)if(gt!==null)if(yt){if($t)if(S.layerUpdates.size>0){let ie=cd(it.width,it.height,S.format,S.type);for(let It of S.layerUpdates){let fe=it.data.subarray(It*ie/it.data.BYTES_PER_ELEMENT,(It+1)*ie/it.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ct,0,0,It,it.width,it.height,1,gt,fe)}}else e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ct,0,0,0,it.width,it.height,st.depth,gt,it.data)}else e.compressedTexImage3D(i.TEXTURE_2D_ARRAY,ct,ot,it.width,it.height,st.depth,0,it.data,0,0);else jt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else yt?$t&&e.texSubImage3D(i.TEXTURE_2D_ARRAY,ct,0,0,0,it.width,it.height,st.depth,gt,F,it.data):e.texImage3D(i.TEXTURE_2D_ARRAY,ct,ot,it.width,it.height,st.depth,0,gt,F,it.data);S.layerUpdates.size>0&&S.clearLayerUpdates()}else{yt&&wt&&e.texStorage2D(i.TEXTURE_2D,ne,ot,At[0].width,At[0].height);for(let ct=0,zt=At.length;ct<zt;ct++)it=At[ct],S.format!==Vi?gt!==null?yt?$t&&e.compressedTexSubImage2D(i.TEXTURE_2D,ct,0,0,it.width,it.height,gt,it.data):e.compressedTexImage2D(i.TEXTURE_2D,ct,ot,it.width,it.height,0,it.data):jt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):yt?$t&&e.texSubImage2D(i.TEXTURE_2D,ct,0,0,it.width,it.height,gt,F,it.data):e.texImage2D(i.TEXTURE_2D,ct,ot,it.width,it.height,0,gt,F,it.data)}else if(S.isDataArrayTexture)if(yt){if(wt&&e.texStorage3D(i.TEXTURE_2D_ARRAY,ne,ot,st.width,st.height,st.depth),$t)if(S.layerUpdates.size>0){let ct=cd(st.width,st.height,S.format,S.type);for(let zt of S.layerUpdates){let ie=st.data.subarray(zt*ct/st.data.BYTES_PER_ELEMENT,(zt+1)*ct/st.data.BYTES_PER_ELEMENT);e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,zt,st.width,st.height,1,gt,F,ie)}S.clearLayerUpdates()}else e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,st.width,st.height,st.depth,gt,F,st.data)}else e.texImage3D(i.TEXTURE_2D_ARRAY,0,ot,st.width,st.height,st.depth,0,gt,F,st.data);else if(S.isData3DTexture)yt?(wt&&e.texStorage3D(i.TEXTURE_3D,ne,ot,st.width,st.height,st.depth),$t&&e.texSubImage3D(i.TEXTURE_3D,0,0,0,0,st.width,st.height,st.depth,gt,F,st.data)):e.texImage3D(i.TEXTURE_3D,0,ot,st.width,st.height,st.depth,0,gt,F,st.data);else if(S.isFramebufferTexture){if(wt)if(yt)e.texStorage2D(i.TEXTURE_2D,ne,ot,st.width,st.height);else{let ct=st.width,zt=st.height;for(let ie=0;ie<ne;ie++)e.texImage2D(i.TEXTURE_2D,ie,ot,ct,zt,0,gt,F,null),ct>>=1,zt>>=1}}else if(S.isHTMLTexture){if("texElementImage2D"in i){let ct=i.canvas;if(ct.hasAttribute("layoutsubtree")||ct.setAttribute("layoutsubtree","true"),st.parentNode!==ct){ct.appendChild(st),u.add(S),ct.onpaint=zt=>{let ie=zt.changedElements;for(let It of u)ie.includes(It.image)&&(It.needsUpdate=!0)},ct.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,st);else{let ie=i.RGBA,It=i.RGBA,fe=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,ie,It,fe,st)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(At.length>0){if(yt&&wt){let ct=Kt(At[0]);e.texStorage2D(i.TEXTURE_2D,ne,ot,ct.width,ct.height)}for(let ct=0,zt=At.length;ct<zt;ct++)it=At[ct],yt?$t&&e.texSubImage2D(i.TEXTURE_2D,ct,0,0,gt,F,it):e.texImage2D(i.TEXTURE_2D,ct,ot,gt,F,it);S.generateMipmaps=!1}else if(yt){if(wt){let ct=Kt(st);e.texStorage2D(i.TEXTURE_2D,ne,ot,ct.width,ct.height)}$t&&e.texSubImage2D(i.TEXTURE_2D,0,0,0,gt,F,st)}else e.texImage2D(i.TEXTURE_2D,0,ot,gt,F,st);C(S)&&S.mipmapsAutoUpdate===!0&&b(ft),Mt.__version=vt.version,S.onUpdate&&S.onUpdate(S)}R.__version=S.version}function un(R,S,q){if(S.image.length!==6)return;let ft=de(R,S),at=S.source;e.bindTexture(i.TEXTURE_CUBE_MAP,R.__webglTexture,i.TEXTURE0+q);let vt=n.get(at);if(at.version!==vt.__version||ft===!0){e.activeTexture(i.TEXTURE0+q);let Mt=Me.getPrimaries(Me.workingColorSpace),nt=S.colorSpace===Ps?null:Me.getPrimaries(S.colorSpace),st=S.colorSpace===Ps||Mt===nt?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,S.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),e.pixelStorei(i.UNPACK_ALIGNMENT,S.unpackAlignment),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,st);let gt=S.isCompressedTexture||S.image[0].isCompressedTexture,F=S.image[0]&&S.image[0].isDataTexture,ot=[];for(let It=0;It<6;It++)!gt&&!F?ot[It]=v(S.image[It],!0,s.maxCubemapSize):ot[It]=F?S.image[It].image:S.image[It],ot[It]=Wt(S,ot[It]);let it=ot[0],At=r.convert(S.format,S.colorSpace),yt=r.convert(S.type),wt=A(S.internalFormat,At,yt,S.normalized,S.colorSpace),$t=S.isVideoTexture!==!0,ne=vt.__version===void 0||ft===!0,ct=at.dataReady,zt=T(S,it);ge(i.TEXTURE_CUBE_MAP,S);let ie;if(S.isDepthTexture){if(wt=x(S.format===Rs,S.type),ne)if($t)e.texStorage2D(i.TEXTURE_CUBE_MAP,1,wt,it.width,it.height);else for(let It=0;It<6;It++)e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+It,0,wt,it.width,it.height,0,At,yt,null)}else if(gt){$t&&ne&&e.texStorage2D(i.TEXTURE_CUBE_MAP,zt,wt,it.width,it.height);for(let It=0;It<6;It++){ie=ot[It].mipmaps;for(let fe=0;fe<ie.length;fe++){let Xe=ie[fe];S.format!==Vi?At!==null?$t?ct&&e.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+It,fe,0,0,Xe.width,Xe.height,At,Xe.data):e.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+It,fe,wt,Xe.width,Xe.height,0,Xe.data):jt("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):$t?ct&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+It,fe,0,0,Xe.width,Xe.height,At,yt,Xe.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+It,fe,wt,Xe.width,Xe.height,0,At,yt,Xe.data)}}}else{if(ie=S.mipmaps,$t&&ne){ie.length>0&&zt++;let It=Kt(ot[0]);e.texStorage2D(i.TEXTURE_CUBE_MAP,zt,wt,It.width,It.height)}for(let It=0;It<6;It++)if(F){$t?ct&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+It,0,0,0,ot[It].width,ot[It].height,At,yt,ot[It].data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+It,0,wt,ot[It].width,ot[It].height,0,At,yt,ot[It].data);for(let fe=0;fe<ie.length;fe++){let Xn=ie[fe].image[It].image;$t?ct&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+It,fe+1,0,0,Xn.width,Xn.height,At,yt,Xn.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+It,fe+1,wt,Xn.width,Xn.height,0,At,yt,Xn.data)}}else{$t?ct&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+It,0,0,0,At,yt,ot[It]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+It,0,wt,At,yt,ot[It]);for(let fe=0;fe<ie.length;fe++){let Xe=ie[fe];$t?ct&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+It,fe+1,0,0,At,yt,Xe.image[It]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+It,fe+1,wt,At,yt,Xe.image[It])}}}C(S)&&S.mipmapsAutoUpdate===!0&&b(i.TEXTURE_CUBE_MAP),vt.__version=at.version,S.onUpdate&&S.onUpdate(S)}R.__version=S.version}function Be(R,S,q,ft,at,vt){let Mt=r.convert(q.format,q.colorSpace),nt=r.convert(q.type),st=A(q.internalFormat,Mt,nt,q.normalized,q.colorSpace),gt=n.get(S),F=n.get(q);if(F.__renderTarget=S,!gt.__hasExternalTextures){let ot=Math.max(1,S.width>>vt),it=Math.max(1,S.height>>vt);at===i.TEXTURE_3D||at===i.TEXTURE_2D_ARRAY?e.texImage3D(at,vt,st,ot,it,S.depth,0,Mt,nt,null):e.texImage2D(at,vt,st,ot,it,0,Mt,nt,null)}e.bindFramebuffer(i.FRAMEBUFFER,R),Et(S)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ft,at,F.__webglTexture,0,he(S)):(at===i.TEXTURE_2D||at>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&at<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,ft,at,F.__webglTexture,vt),e.bindFramebuffer(i.FRAMEBUFFER,null)}function Rn(R,S,q){if(i.bindRenderbuffer(i.RENDERBUFFER,R),S.depthBuffer){let ft=S.depthTexture,at=ft&&ft.isDepthTexture?ft.type:null,vt=x(S.stencilBuffer,at),Mt=S.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;Et(S)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,he(S),vt,S.width,S.height):q?i.renderbufferStorageMultisample(i.RENDERBUFFER,he(S),vt,S.width,S.height):i.renderbufferStorage(i.RENDERBUFFER,vt,S.width,S.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,Mt,i.RENDERBUFFER,R)}else{let ft=S.textures;for(let at=0;at<ft.length;at++){let vt=ft[at],Mt=r.convert(vt.format,vt.colorSpace),nt=r.convert(vt.type),st=A(vt.internalFormat,Mt,nt,vt.normalized,vt.colorSpace);Et(S)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,he(S),st,S.width,S.height):q?i.renderbufferStorageMultisample(i.RENDERBUFFER,he(S),st,S.width,S.height):i.renderbufferStorage(i.RENDERBUFFER,st,S.width,S.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function we(R,S,q){let ft=S.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(i.FRAMEBUFFER,R),!(S.depthTexture&&S.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let at=n.get(S.depthTexture);at.__renderTarget=S;let vt=ft?S.depthTexture.image[0]:S.depthTexture.image;(!at.__webglTexture||vt.width!==S.width||vt.height!==S.height)&&(vt.width=S.width,vt.height=S.height,S.depthTexture.needsUpdate=!0),ft?Tt(S.depthTexture,0):xt(S.depthTexture,0);let Mt=at.__webglTexture,nt=he(S),st=ft?i.TEXTURE_CUBE_MAP_POSITIVE_X+q:i.TEXTURE_2D,gt=S.depthTexture.format===Rs?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(S.depthTexture.format===Ts)Et(S)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,gt,st,Mt,0,nt):i.framebufferTexture2D(i.FRAMEBUFFER,gt,st,Mt,0);else if(S.depthTexture.format===Rs)Et(S)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,gt,st,Mt,0,nt):i.framebufferTexture2D(i.FRAMEBUFFER,gt,st,Mt,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function yn(R){let S=n.get(R),q=R.isWebGLCubeRenderTarget===!0;if(S.__boundDepthTexture!==R.depthTexture){let ft=R.depthTexture;if(S.__depthDisposeCallback&&S.__depthDisposeCallback(),ft){let at=()=>{delete S.__boundDepthTexture,delete S.__depthDisposeCallback,ft.removeEventListener("dispose",at)};ft.addEventListener("dispose",at),S.__depthDisposeCallback=at}S.__boundDepthTexture=ft}if(R.depthTexture&&!S.__autoAllocateDepthBuffer)if(q)for(let ft=0;ft<6;ft++)we(S.__webglFramebuffer[ft],R,ft);else R.texture.mipmaps.length>0?we(S.__webglFramebuffer[0],R,0):we(S.__webglFramebuffer,R,0);else if(q){S.__webglDepthbuffer=[];for(let ft=0;ft<6;ft++)if(e.bindFramebuffer(i.FRAMEBUFFER,S.__webglFramebuffer[ft]),S.__webglDepthbuffer[ft]===void 0)S.__webglDepthbuffer[ft]=i.createRenderbuffer(),Rn(S.__webglDepthbuffer[ft],R,!1);else{let at=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,vt=S.__webglDepthbuffer[ft];i.bindRenderbuffer(i.RENDERBUFFER,vt),i.framebufferRenderbuffer(i.FRAMEBUFFER,at,i.RENDERBUFFER,vt)}}else if(R.texture.mipmaps.length>0?e.bindFramebuffer(i.FRAMEBUFFER,S.__webglFramebuffer[0]):e.bindFramebuffer(i.FRAMEBUFFER,S.__webglFramebuffer),S.__webglDepthbuffer===void 0)S.__webglDepthbuffer=i.createRenderbuffer(),Rn(S.__webglDepthbuffer,R,!1);else{let at=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,vt=S.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,vt),i.framebufferRenderbuffer(i.FRAMEBUFFER,at,i.RENDERBUFFER,vt)}e.bindFramebuffer(i.FRAMEBUFFER,null)}function en(R,S,q){let ft=n.get(R);S!==void 0&&Be(ft.__webglFramebuffer,R,R.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),q!==void 0&&yn(R)}function fn(R){let S=R.texture,q=n.get(R),ft=n.get(S);R.addEventListener("dispose",z),k(R);let at=R.textures,vt=R.isWebGLCubeRenderTarget===!0,Mt=at.length>1;if(Mt||(ft.__webglTexture===void 0&&(ft.__webglTexture=i.createTexture()),ft.__version=S.version,o.memory.textures++),vt){q.__webglFramebuffer=[];for(let nt=0;nt<6;nt++)if(S.mipmaps.length>0){q.__webglFramebuffer[nt]=[];for(let st=0;st<S.mipmaps.length;st++)q.__webglFramebuffer[nt][st]=i.createFramebuffer()}else q.__webglFramebuffer[nt]=i.createFramebuffer()}else{if(S.mipmaps.length>0){q.__webglFramebuffer=[];for(let nt=0;nt<S.mipmaps.length;nt++)q.__webglFramebuffer[nt]=i.createFramebuffer()}else q.__webglFramebuffer=i.createFramebuffer();if(Mt)for(let nt=0,st=at.length;nt<st;nt++){let gt=n.get(at[nt]);gt.__webglTexture===void 0&&(gt.__webglTexture=i.createTexture(),o.memory.textures++)}if(R.samples>0&&Et(R)===!1){q.__webglMultisampledFramebuffer=i.createFramebuffer(),q.__webglColorRenderbuffer=[],e.bindFramebuffer(i.FRAMEBUFFER,q.__webglMultisampledFramebuffer);for(let nt=0;nt<at.length;nt++){let st=at[nt];q.__webglColorRenderbuffer[nt]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,q.__webglColorRenderbuffer[nt]);let gt=r.convert(st.format,st.colorSpace),F=r.convert(st.type),ot=A(st.internalFormat,gt,F,st.normalized,st.colorSpace,R.isXRRenderTarget===!0),it=he(R);i.renderbufferStorageMultisample(i.RENDERBUFFER,it,ot,R.width,R.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+nt,i.RENDERBUFFER,q.__webglColorRenderbuffer[nt])}i.bindRenderbuffer(i.RENDERBUFFER,null),R.depthBuffer&&(q.__webglDepthRenderbuffer=i.createRenderbuffer(),Rn(q.__webglDepthRenderbuffer,R,!0)),e.bindFramebuffer(i.FRAMEBUFFER,null)}}if(vt){e.bindTexture(i.TEXTURE_CUBE_MAP,ft.__webglTexture),ge(i.TEXTURE_CUBE_MAP,S);for(let nt=0;nt<6;nt++)if(S.mipmaps.length>0)for(let st=0;st<S.mipmaps.length;st++)Be(q.__webglFramebuffer[nt][st],R,S,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+nt,st);else Be(q.__webglFramebuffer[nt],R,S,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+nt,0);C(S)?b(i.TEXTURE_CUBE_MAP):S.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),e.unbindTexture()}else if(Mt){for(let nt=0,st=at.length;nt<st;nt++){let gt=at[nt],F=n.get(gt),ot=i.TEXTURE_2D;(R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(ot=R.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(ot,F.__webglTexture),ge(ot,gt),Be(q.__webglFramebuffer,R,gt,i.COLOR_ATTACHMENT0+nt,ot,0),C(gt)&&b(ot)}e.unbindTexture()}else{let nt=i.TEXTURE_2D;if((R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(nt=R.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(nt,ft.__webglTexture),ge(nt,S),S.mipmaps.length>0)for(let st=0;st<S.mipmaps.length;st++)Be(q.__webglFramebuffer[st],R,S,i.COLOR_ATTACHMENT0,nt,st);else Be(q.__webglFramebuffer,R,S,i.COLOR_ATTACHMENT0,nt,0);C(S)?b(nt):S.mipmaps.length>0&&i.texParameteri(nt,i.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),e.unbindTexture()}R.depthBuffer&&yn(R)}function O(R){let S=R.textures;for(let q=0,ft=S.length;q<ft;q++){let at=S[q];if(C(at)&&at.mipmapsAutoUpdate===!0){let vt=P(R),Mt=n.get(at).__webglTexture;e.bindTexture(vt,Mt),b(vt),e.unbindTexture()}}}let Lt=[];function Qt(R){if(R.samples>0){if(Et(R)===!1){let S=R.textures,q=R.width,ft=R.height,at=i.COLOR_BUFFER_BIT,vt=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,Mt=n.get(R),nt=S.length>1;if(nt)for(let gt=0;gt<S.length;gt++)e.bindFramebuffer(i.FRAMEBUFFER,Mt.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+gt,i.RENDERBUFFER,null),e.bindFramebuffer(i.FRAMEBUFFER,Mt.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+gt,i.TEXTURE_2D,null,0);e.bindFramebuffer(i.READ_FRAMEBUFFER,Mt.__webglMultisampledFramebuffer),R.texture.mipmaps.length>0?e.bindFramebuffer(i.DRAW_FRAMEBUFFER,Mt.__webglFramebuffer[0]):e.bindFramebuffer(i.DRAW_FRAMEBUFFER,Mt.__webglFramebuffer);for(let gt=0;gt<S.length;gt++){if(R.resolveDepthBuffer&&(R.depthBuffer&&(at|=i.DEPTH_BUFFER_BIT),R.stencilBuffer&&R.resolveStencilBuffer&&(at|=i.STENCIL_BUFFER_BIT)),nt){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,Mt.__webglColorRenderbuffer[gt]);let F=n.get(S[gt]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,F,0)}i.blitFramebuffer(0,0,q,ft,0,0,q,ft,at,i.NEAREST),l===!0&&(Lt.length=0,Lt.push(i.COLOR_ATTACHMENT0+gt),R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&Lt.push(vt),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Lt))}if(e.bindFramebuffer(i.READ_FRAMEBUFFER,null),e.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),nt)for(let gt=0;gt<S.length;gt++){e.bindFramebuffer(i.FRAMEBUFFER,Mt.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+gt,i.RENDERBUFFER,Mt.__webglColorRenderbuffer[gt]);let F=n.get(S[gt]).__webglTexture;e.bindFramebuffer(i.FRAMEBUFFER,Mt.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+gt,i.TEXTURE_2D,F,0)}e.bindFramebuffer(i.DRAW_FRAMEBUFFER,Mt.__webglMultisampledFramebuffer)}else if(R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&l){let S=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[S])}}}function he(R){return Math.min(s.maxSamples,R.samples)}function Et(R){let S=n.get(R);return R.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&S.__useRenderToTexture!==!1}function ze(R){let S=o.render.frame;h.get(R)!==S&&(h.set(R,S),R.update())}function Wt(R,S){let q=R.colorSpace,ft=R.format,at=R.type;return R.isCompressedTexture===!0||R.isVideoTexture===!0||q!==da&&q!==Ps&&(Me.getTransfer(q)===Le?(ft!==Vi||at!==ai)&&jt("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):se("WebGLTextures: Unsupported texture color space:",q)),S}function Kt(R){return typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement?(c.width=R.naturalWidth||R.width,c.height=R.naturalHeight||R.height):typeof VideoFrame<"u"&&R instanceof VideoFrame?(c.width=R.displayWidth,c.height=R.displayHeight):(c.width=R.width,c.height=R.height),c}this.allocateTextureUnit=dt,this.resetTextureUnits=tt,this.getTextureUnits=rt,this.setTextureUnits=pt,this.setTexture2D=xt,this.setTexture2DArray=St,this.setTexture3D=Pt,this.setTextureCube=Tt,this.rebindTextures=en,this.setupRenderTarget=fn,this.updateRenderTargetMipmap=O,this.updateMultisampleRenderTarget=Qt,this.setupDepthRenderbuffer=yn,this.setupFrameBufferTexture=Be,this.useMultisampledRTT=Et,this.dispose=X}function TE(i,t){function e(n,s=Ps){let r,o=Me.getTransfer(s);if(n===ai)return i.UNSIGNED_BYTE;if(n===rh)return i.UNSIGNED_SHORT_4_4_4_4;if(n===oh)return i.UNSIGNED_SHORT_5_5_5_1;if(n===Xf)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===qf)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===Hf)return i.BYTE;if(n===Wf)return i.SHORT;if(n===Ao)return i.UNSIGNED_SHORT;if(n===sh)return i.INT;if(n===Bi)return i.UNSIGNED_INT;if(n===ki)return i.FLOAT;if(n===zi)return i.HALF_FLOAT;if(n===$f)return i.ALPHA;if(n===Yf)return i.RGB;if(n===Vi)return i.RGBA;if(n===Ts)return i.DEPTH_COMPONENT;if(n===Rs)return i.DEPTH_STENCIL;if(n===Zf)return i.RED;if(n===ah)return i.RED_INTEGER;if(n===er)return i.RG;if(n===lh)return i.RG_INTEGER;if(n===ch)return i.RGBA_INTEGER;if(n===Ga||n===Ha||n===Wa||n===Xa)if(o===Le)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===Ga)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===Ha)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Wa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===Xa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===Ga)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===Ha)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Wa)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===Xa)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===hh||n===uh||n===fh||n===dh)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===hh)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===uh)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===fh)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===dh)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===ph||n===mh||n===gh||n===_h||n===xh||n===qa||n===yh)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(n===ph||n===mh)return o===Le?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===gh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===_h)return r.COMPRESSED_R11_EAC;if(n===xh)return r.COMPRESSED_SIGNED_R11_EAC;if(n===qa)return r.COMPRESSED_RG11_EAC;if(n===yh)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===vh||n===Sh||n===Mh||n===bh||n===wh||n===Th||n===Eh||n===Ah||n===Ch||n===Rh||n===Ph||n===Ih||n===Lh||n===Dh)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(n===vh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===Sh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===Mh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===bh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===wh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===Th)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===Eh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===Ah)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===Ch)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===Rh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===Ph)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===Ih)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===Lh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===Dh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===Nh||n===Uh||n===Fh)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(n===Nh)return o===Le?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===Uh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===Fh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===Oh||n===Bh||n===$a||n===kh)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(n===Oh)return r.COMPRESSED_RED_RGTC1_EXT;if(n===Bh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===$a)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===kh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===Mr?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:e}}var EE=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,AE=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,xd=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let n=new Aa(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=n}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,n=new os({vertexShader:EE,fragmentShader:AE,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new bn(new Ra(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},yd=class extends Oi{constructor(t,e){super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,u=null,f=null,d=null,g=null,y=typeof XRWebGLBinding<"u",p=new xd,m={},v=e.getContextAttributes(),C=null,b=null,P=[],A=[],x=new Jt,T=null,k=null,U=new jn;U.viewport=new Qe;let N=new jn;N.viewport=new Qe;let z=[U,N],W=new th,D=null,X=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(et){let xt=P[et];return xt===void 0&&(xt=new xo,P[et]=xt),xt.getTargetRaySpace()},this.getControllerGrip=function(et){let xt=P[et];return xt===void 0&&(xt=new xo,P[et]=xt),xt.getGripSpace()},this.getHand=function(et){let xt=P[et];return xt===void 0&&(xt=new xo,P[et]=xt),xt.getHandSpace()};function Z(et){let xt=A.indexOf(et.inputSource);if(xt===-1)return;let St=P[xt];St!==void 0&&(St.update(et.inputSource,et.frame,c||o),St.dispatchEvent({type:et.type,data:et.inputSource}))}function H(){s.removeEventListener("select",Z),s.removeEventListener("selectstart",Z),s.removeEventListener("selectend",Z),s.removeEventListener("squeeze",Z),s.removeEventListener("squeezestart",Z),s.removeEventListener("squeezeend",Z),s.removeEventListener("end",H),s.removeEventListener("inputsourceschange",ht);for(let et=0;et<P.length;et++){let xt=A[et];xt!==null&&(A[et]=null,P[et].disconnect(xt))}D=null,X=null,p.reset();for(let et in m)delete m[et];if(t.setRenderTarget(C),d=null,f=null,u=null,s=null,b=null,dt.stop(),n.isPresenting=!1,t.setPixelRatio(T),t.setSize(x.width,x.height,!1),k!==null){let et=k.camera;et.fov=k.fov,et.zoom=k.zoom,et.updateProjectionMatrix(),k=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(et){r=et,n.isPresenting===!0&&jt("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(et){a=et,n.isPresenting===!0&&jt("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(et){c=et},this.getBaseLayer=function(){return f!==null?f:d},this.getBinding=function(){return u===null&&y&&(u=new XRWebGLBinding(s,e)),u},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(et){if(s=et,s!==null){if(C=t.getRenderTarget(),s.addEventListener("select",Z),s.addEventListener("selectstart",Z),s.addEventListener("selectend",Z),s.addEventListener("squeeze",Z),s.addEventListener("squeezestart",Z),s.addEventListener("squeezeend",Z),s.addEventListener("end",H),s.addEventListener("inputsourceschange",ht),v.xrCompatible!==!0&&await e.makeXRCompatible(),T=t.getPixelRatio(),t.getSize(x),y&&"createProjectionLayer"in XRWebGLBinding.prototype){let St=null,Pt=null,Tt=null;v.depth&&(Tt=v.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,St=v.stencil?Rs:Ts,Pt=v.stencil?Mr:Bi);let Yt={colorFormat:e.RGBA8,depthFormat:Tt,scaleFactor:r};u=this.getBinding(),f=u.createProjectionLayer(Yt),s.updateRenderState({layers:[f]}),t.setPixelRatio(1),t.setSize(f.textureWidth,f.textureHeight,!1),b=new gi(f.textureWidth,f.textureHeight,{format:Vi,type:ai,depthTexture:new As(f.textureWidth,f.textureHeight,Pt,void 0,void 0,void 0,void 0,void 0,void 0,St),stencilBuffer:v.stencil,colorSpace:t.outputColorSpace,samples:v.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}else{let St={antialias:v.antialias,alpha:!0,depth:v.depth,stencil:v.stencil,framebufferScaleFactor:r};d=new XRWebGLLayer(s,e,St),s.updateRenderState({baseLayer:d}),t.setPixelRatio(1),t.setSize(d.framebufferWidth,d.framebufferHeight,!1),b=new gi(d.framebufferWidth,d.framebufferHeight,{format:Vi,type:ai,colorSpace:t.outputColorSpace,stencilBuffer:v.stencil,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}b.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),dt.setContext(s),dt.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return p.getDepthTexture()};function ht(et){for(let xt=0;xt<et.removed.length;xt++){let St=et.removed[xt],Pt=A.indexOf(St);Pt>=0&&(A[Pt]=null,P[Pt].disconnect(St))}for(let xt=0;xt<et.added.length;xt++){let St=et.added[xt],Pt=A.indexOf(St);if(Pt===-1){for(let Yt=0;Yt<P.length;Yt++)if(Yt>=A.length){A.push(St),Pt=Yt;break}else if(A[Yt]===null){A[Yt]=St,Pt=Yt;break}if(Pt===-1)break}let Tt=P[Pt];Tt&&Tt.connect(St)}}function j(et,xt){xt===null?et.matrixWorld.copy(et.matrix):et.matrixWorld.multiplyMatrices(xt.matrixWorld,et.matrix),et.matrixWorldInverse.copy(et.matrixWorld).invert()}this.updateCamera=function(et){if(s===null)return;let xt=et.near,St=et.far;p.texture!==null&&(p.depthNear>0&&(xt=p.depthNear),p.depthFar>0&&(St=p.depthFar)),W.near=N.near=U.near=xt,W.far=N.far=U.far=St,(D!==W.near||X!==W.far)&&(s.updateRenderState({depthNear:W.near,depthFar:W.far}),D=W.near,X=W.far),W.layers.mask=et.layers.mask|6,U.layers.mask=W.layers.mask&-5,N.layers.mask=W.layers.mask&-3;let Pt=et.parent,Tt=W.cameras;j(W,Pt);for(let Yt=0;Yt<Tt.length;Yt++)j(Tt[Yt],Pt);W.projectionMatrix.copy(U.projectionMatrix),W.projectionMatrixInverse.copy(U.projectionMatrixInverse),k===null&&et.isPerspectiveCamera&&(k={camera:et,fov:et.fov,zoom:et.zoom}),tt(et,W,Pt)};function tt(et,xt,St){St===null?et.matrix.copy(xt.matrixWorld):(et.matrix.copy(St.matrixWorld),et.matrix.invert(),et.matrix.multiply(xt.matrixWorld)),et.matrix.decompose(et.position,et.quaternion,et.scale),et.updateMatrixWorld(!0),et.projectionMatrix.copy(xt.projectionMatrix),et.projectionMatrixInverse.copy(xt.projectionMatrixInverse),et.isPerspectiveCamera&&(et.fov=go*2*Math.atan(1/et.projectionMatrix.elements[5]),et.zoom=1)}this.getCamera=function(){return W},this.getFoveation=function(){if(!(f===null&&d===null))return l},this.setFoveation=function(et){l=et,f!==null&&(f.fixedFoveation=et),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=et)},this.hasDepthSensing=function(){return p.texture!==null},this.getDepthSensingMesh=function(){return p.getMesh(W)},this.getCameraTexture=function(et){return m[et]};let rt=null;function pt(et,xt){if(h=xt.getViewerPose(c||o),g=xt,h!==null){let St=h.views;d!==null&&(t.setRenderTargetFramebuffer(b,d.framebuffer),t.setRenderTarget(b));let Pt=!1;St.length!==W.cameras.length&&(W.cameras.length=0,Pt=!0);for(let qt=0;qt<St.length;qt++){let ge=St[qt],de=null;if(d!==null)de=d.getViewport(ge);else{let Ke=u.getViewSubImage(f,ge);de=Ke.viewport,qt===0&&(t.setRenderTargetTextures(b,Ke.colorTexture,Ke.depthStencilTexture),t.setRenderTarget(b))}let ae=z[qt];ae===void 0&&(ae=new jn,ae.layers.enable(qt),ae.viewport=new Qe,z[qt]=ae),ae.matrix.fromArray(ge.transform.matrix),ae.matrix.decompose(ae.position,ae.quaternion,ae.scale),ae.projectionMatrix.fromArray(ge.projectionMatrix),ae.projectionMatrixInverse.copy(ae.projectionMatrix).invert(),ae.viewport.set(de.x,de.y,de.width,de.height),qt===0&&(W.matrix.copy(ae.matrix),W.matrix.decompose(W.position,W.quaternion,W.scale)),Pt===!0&&W.cameras.push(ae)}let Tt=s.enabledFeatures;if(Tt&&Tt.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&y){u=n.getBinding();let qt=u.getDepthInformation(St[0]);qt&&qt.isValid&&qt.texture&&p.init(qt,s.renderState)}if(Tt&&Tt.includes("camera-access")&&y){t.state.unbindTexture(),u=n.getBinding();for(let qt=0;qt<St.length;qt++){let ge=St[qt].camera;if(ge){let de=m[ge];de||(de=new Aa,m[ge]=de);let ae=u.getCameraImage(ge);de.sourceTexture=ae}}}}for(let St=0;St<P.length;St++){let Pt=A[St],Tt=P[St];Pt!==null&&Tt!==void 0&&Tt.update(Pt,xt,c||o)}rt&&rt(et,xt),xt.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:xt}),g=null}let dt=new P0;dt.setAnimationLoop(pt),this.setAnimationLoop=function(et){rt=et},this.dispose=function(){}}},CE=new De,z0=new oe;z0.set(-1,0,0,0,1,0,0,0,1);function RE(i,t){function e(p,m){p.matrixAutoUpdate===!0&&p.updateMatrix(),m.value.copy(p.matrix)}function n(p,m){m.color.getRGB(p.fogColor.value,od(i)),m.isFog?(p.fogNear.value=m.near,p.fogFar.value=m.far):m.isFogExp2&&(p.fogDensity.value=m.density)}function s(p,m,v,C,b){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?r(p,m):m.isMeshLambertMaterial?(r(p,m),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(r(p,m),u(p,m)):m.isMeshPhongMaterial?(r(p,m),h(p,m),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(r(p,m),f(p,m),m.isMeshPhysicalMaterial&&d(p,m,b)):m.isMeshMatcapMaterial?(r(p,m),g(p,m)):m.isMeshDepthMaterial?r(p,m):m.isMeshDistanceMaterial?(r(p,m),y(p,m)):m.isMeshNormalMaterial?r(p,m):m.isLineBasicMaterial?(o(p,m),m.isLineDashedMaterial&&a(p,m)):m.isPointsMaterial?l(p,m,v,C):m.isSpriteMaterial?c(p,m):m.isShadowMaterial?(p.color.value.copy(m.color),p.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function r(p,m){p.opacity.value=m.opacity,m.color&&p.diffuse.value.copy(m.color),m.emissive&&p.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(p.map.value=m.map,e(m.map,p.mapTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,e(m.alphaMap,p.alphaMapTransform)),m.bumpMap&&(p.bumpMap.value=m.bumpMap,e(m.bumpMap,p.bumpMapTransform),p.bumpScale.value=m.bumpScale,m.side===ni&&(p.bumpScale.value*=-1)),m.normalMap&&(p.normalMap.value=m.normalMap,e(m.normalMap,p.normalMapTransform),p.normalScale.value.copy(m.normalScale),m.side===ni&&p.normalScale.value.negate()),m.displacementMap&&(p.displacementMap.value=m.displacementMap,e(m.displacementMap,p.displacementMapTransform),p.displacementScale.value=m.displacementScale,p.displacementBias.value=m.displacementBias),m.emissiveMap&&(p.emissiveMap.value=m.emissiveMap,e(m.emissiveMap,p.emissiveMapTransform)),m.specularMap&&(p.specularMap.value=m.specularMap,e(m.specularMap,p.specularMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest);let v=t.get(m),C=v.envMap,b=v.envMapRotation;C&&(p.envMap.value=C,p.envMapRotation.value.setFromMatrix4(CE.makeRotationFromEuler(b)).transpose(),C.isCubeTexture&&C.isRenderTargetTexture===!1&&p.envMapRotation.value.premultiply(z0),p.reflectivity.value=m.reflectivity,p.ior.value=m.ior,p.refractionRatio.value=m.refractionRatio),m.lightMap&&(p.lightMap.value=m.lightMap,p.lightMapIntensity.value=m.lightMapIntensity,e(m.lightMap,p.lightMapTransform)),m.aoMap&&(p.aoMap.value=m.aoMap,p.aoMapIntensity.value=m.aoMapIntensity,e(m.aoMap,p.aoMapTransform))}function o(p,m){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,m.map&&(p.map.value=m.map,e(m.map,p.mapTransform))}function a(p,m){p.dashSize.value=m.dashSize,p.totalSize.value=m.dashSize+m.gapSize,p.scale.value=m.scale}function l(p,m,v,C){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,p.size.value=m.size*v,p.scale.value=C*.5,m.map&&(p.map.value=m.map,e(m.map,p.uvTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,e(m.alphaMap,p.alphaMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest)}function c(p,m){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,p.rotation.value=m.rotation,m.map&&(p.map.value=m.map,e(m.map,p.mapTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,e(m.alphaMap,p.alphaMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest)}function h(p,m){p.specular.value.copy(m.specular),p.shininess.value=Math.max(m.shininess,1e-4)}function u(p,m){m.gradientMap&&(p.gradientMap.value=m.gradientMap)}function f(p,m){p.metalness.value=m.metalness,m.metalnessMap&&(p.metalnessMap.value=m.metalnessMap,e(m.metalnessMap,p.metalnessMapTransform)),p.roughness.value=m.roughness,m.roughnessMap&&(p.roughnessMap.value=m.roughnessMap,e(m.roughnessMap,p.roughnessMapTransform)),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)}function d(p,m,v){p.ior.value=m.ior,m.diffuseRoughness>0&&(p.diffuseRoughness.value=m.diffuseRoughness,m.diffuseRoughnessMap&&(p.diffuseRoughnessMap.value=m.diffuseRoughnessMap,e(m.diffuseRoughnessMap,p.diffuseRoughnessMapTransform))),m.sheen>0&&(p.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),p.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(p.sheenColorMap.value=m.sheenColorMap,e(m.sheenColorMap,p.sheenColorMapTransform)),m.sheenRoughnessMap&&(p.sheenRoughnessMap.value=m.sheenRoughnessMap,e(m.sheenRoughnessMap,p.sheenRoughnessMapTransform))),m.clearcoat>0&&(p.clearcoat.value=m.clearcoat,p.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(p.clearcoatMap.value=m.clearcoatMap,e(m.clearcoatMap,p.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(p.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,e(m.clearcoatRoughnessMap,p.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(p.clearcoatNormalMap.value=m.clearcoatNormalMap,e(m.clearcoatNormalMap,p.clearcoatNormalMapTransform),p.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===ni&&p.clearcoatNormalScale.value.negate())),m.dispersion>0&&(p.dispersion.value=m.dispersion),m.retroreflectivity>0&&(p.retroreflectivity.value=m.retroreflectivity),m.iridescence>0&&(p.iridescence.value=m.iridescence,p.iridescenceIOR.value=m.iridescenceIOR,p.iridescenceThicknessMinimum.value=m.iridescenceThicknessMinimum,p.iridescenceThicknessMaximum.value=m.iridescenceThicknessMaximum,m.iridescenceMap&&(p.iridescenceMap.value=m.iridescenceMap,e(m.iridescenceMap,p.iridescenceMapTransform)),m.iridescenceThicknessMap&&(p.iridescenceThicknessMap.value=m.iridescenceThicknessMap,e(m.iridescenceThicknessMap,p.iridescenceThicknessMapTransform))),m.transmission>0&&(p.transmission.value=m.transmission,p.transmissionSamplerMap.value=v.texture,p.transmissionSamplerSize.value.set(v.width,v.height),m.transmissionMap&&(p.transmissionMap.value=m.transmissionMap,e(m.transmissionMap,p.transmissionMapTransform)),p.thickness.value=m.thickness,m.thicknessMap&&(p.thicknessMap.value=m.thicknessMap,e(m.thicknessMap,p.thicknessMapTransform)),p.attenuationDistance.value=m.attenuationDistance,p.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(p.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(p.anisotropyMap.value=m.anisotropyMap,e(m.anisotropyMap,p.anisotropyMapTransform))),p.specularIntensity.value=m.specularIntensity,p.specularColor.value.copy(m.specularColor),m.specularColorMap&&(p.specularColorMap.value=m.specularColorMap,e(m.specularColorMap,p.specularColorMapTransform)),m.specularIntensityMap&&(p.specularIntensityMap.value=m.specularIntensityMap,e(m.specularIntensityMap,p.specularIntensityMapTransform))}function g(p,m){m.matcap&&(p.matcap.value=m.matcap)}function y(p,m){let v=t.get(m).light;p.referencePosition.value.setFromMatrixPosition(v.matrixWorld),p.nearDistance.value=v.shadow.camera.near,p.farDistance.value=v.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function PE(i,t,e,n){let s={},r={};function o(v,C){let b=C.program;n.uniformBlockBinding(v,b,s[v.id])}function a(v,C){let b=s[v.id];b===void 0&&(g(v),b=l(v),s[v.id]=b,v.addEventListener("dispose",p));let P=C.program;n.updateUBOMapping(v,P);let A=t.render.frame;r[v.id]!==A&&(c(v),r[v.id]=A)}function l(v){let C=i.createBuffer(),b=v.__size,P=v.usage;return i.bindBuffer(i.UNIFORM_BUFFER,C),i.bufferData(i.UNIFORM_BUFFER,b,P),i.bindBuffer(i.UNIFORM_BUFFER,null),C}function c(v){let C=s[v.id],b=v.uniforms,P=v.__cache;i.bindBuffer(i.UNIFORM_BUFFER,C);for(let A=0,x=b.length;A<x;A++){let T=b[A];if(Array.isArray(T))for(let k=0,U=T.length;k<U;k++)h(T[k],A,k,P);else h(T,A,0,P)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function h(v,C,b,P){if(f(v,C,b,P)===!0){let A=v.__offset,x=v.value;if(Array.isArray(x)){let T=0;for(let k=0;k<x.length;k++){let U=x[k],N=y(U,!0);u(U,v.__data,T),T+=N.storage/Float32Array.BYTES_PER_ELEMENT}}else u(x,v.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,A,v.__data)}}function u(v,C,b){typeof v=="number"||typeof v=="boolean"?C[b]=v:v.isMatrix3?(C[b]=v.elements[0],C[b+1]=v.elements[1],C[b+2]=v.elements[2],C[b+3]=0,C[b+4]=v.elements[3],C[b+5]=v.elements[4],C[b+6]=v.elements[5],C[b+7]=0,C[b+8]=v.elements[6],C[b+9]=v.elements[7],C[b+10]=v.elements[8],C[b+11]=0):ArrayBuffer.isView(v)?C.set(v.subarray(0,C.length-b),b):v.toArray(C,b)}function f(v,C,b,P){let A=v.value,x=C+"_"+b;if(Array.isArray(A)){P[x]===void 0&&(P[x]=[]);let T=P[x],k=!1;for(let U=0;U<A.length;U++)d(A[U],T,U)===!0&&(k=!0);return k}return d(A,P,x)}function d(v,C,b){if(C[b]===void 0)return typeof v=="number"||typeof v=="boolean"?C[b]=v:ArrayBuffer.isView(v)?C[b]=v.slice():C[b]=v.clone(),!0;{let P=C[b];if(typeof v=="number"||typeof v=="boolean"){if(P!==v)return C[b]=v,!0}else{if(ArrayBuffer.isView(v))return!0;if(P.equals(v)===!1)return P.copy(v),!0}}return!1}function g(v){let C=v.uniforms,b=0,P=16;for(let x=0,T=C.length;x<T;x++){let k=Array.isArray(C[x])?C[x]:[C[x]];for(let U=0,N=k.length;U<N;U++){let z=k[U],W=Array.isArray(z.value)?z.value:[z.value],D=Array.isArray(C[x])||Array.isArray(z.value),X=b;for(let H=0,ht=W.length;H<ht;H++){let j=W[H],tt=y(j,D),rt=b%P,pt=rt%tt.boundary,dt=rt+pt;b+=pt,dt!==0&&P-dt<tt.storage&&(b+=P-dt),H===0&&(X=b),b+=tt.storage}let Z=z.type==="int"?Int32Array:z.type==="uint"?Uint32Array:Float32Array;z.__data=new Z((b-X)/Float32Array.BYTES_PER_ELEMENT),z.__offset=X}}let A=b%P;return A>0&&(b+=P-A),v.__size=b,v.__cache={},this}function y(v,C){let b={boundary:0,storage:0};return typeof v=="number"||typeof v=="boolean"?(b.boundary=4,b.storage=4):v.isVector2?(b.boundary=8,b.storage=8):v.isVector3||v.isColor?(b.boundary=16,b.storage=12):v.isVector4?(b.boundary=16,b.storage=16):v.isMatrix3?(b.boundary=16,b.storage=48):v.isMatrix4?(b.boundary=16,b.storage=64):v.isTexture?jt("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(v)?(b.boundary=16,b.storage=v.byteLength):jt("WebGLRenderer: Unsupported uniform value type.",v),C===!0&&(b.boundary=16,b.storage=Math.ceil(b.storage/16)*16),b}function p(v){let C=v.target;C.removeEventListener("dispose",p),i.deleteBuffer(s[C.id]),delete s[C.id],delete r[C.id]}function m(){for(let v in s)i.deleteBuffer(s[v]);s={},r={}}return{bind:o,update:a,dispose:m}}var IE=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),cs=null;function LE(){return cs===null&&(cs=new Fc(IE,16,16,er,zi),cs.name="DFG_LUT",cs.minFilter=Qn,cs.magFilter=Qn,cs.wrapS=ns,cs.wrapT=ns,cs.generateMipmaps=!1,cs.needsUpdate=!0),cs}var Xh=class{constructor(t={}){let{canvas:e=t0(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:f=!1,outputBufferType:d=ai}=t;this.isWebGLRenderer=!0;let g;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=n.getContextAttributes().alpha}else g=o;let y=d,p=new Set([ch,lh,ah]),m=new Set([ai,Bi,Ao,Mr,rh,oh]),v=new Uint32Array(4),C=new Int32Array(4),b={textures:[],min:[],max:[],resolution:[]},P=null,A=null,x=[],T=[],k=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=ls,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let U=this,N=!1,z=null,W=null,D=null,X=null;this._outputColorSpace=Kn;let Z=0,H=0,ht=null,j=-1,tt=null,rt=new Qe,pt=new Qe,dt=null,et=new ue(0),xt=0,St=e.width,Pt=e.height,Tt=1,Yt=null,ce=null,qt=new Qe(0,0,St,Pt),ge=new Qe(0,0,St,Pt),de=!1,ae=new Ys,Ke=new Oc,He=!1,un=!1,Be=new De,Rn=new G,we=new Qe,yn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},en=!1;function fn(){return ht===null?Tt:1}let O=n;function Lt(w,B){return e.getContext(w,B)}let Qt,he,Et,ze,Wt,Kt,R,S,q,ft,at,vt,Mt,nt,st,gt,F,ot,it,At,yt,wt,$t;try{let w={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",zt,!1),e.addEventListener("webglcontextrestored",ie,!1),e.addEventListener("webglcontextcreationerror",It,!1),O===null){let B="webgl2";if(O=Lt(B,w),O===null)throw Lt(B)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}ne()}catch(w){throw e.removeEventListener("webglcontextlost",zt,!1),e.removeEventListener("webglcontextrestored",ie,!1),e.removeEventListener("webglcontextcreationerror",It,!1),se("WebGLRenderer: "+w.message),w}function ne(){Qt=new Hw(O),Qt.init(),yt=new TE(O,Qt),he=new Lw(O,Qt,t,yt),Et=new bE(O,Qt),he.reversedDepthBuffer&&f&&Et.buffers.depth.setReversed(!0),W=O.createFramebuffer(),D=O.createFramebuffer(),X=O.createFramebuffer(),ze=new qw(O),Wt=new cE,Kt=new wE(O,Qt,Et,Wt,he,yt,ze),R=new Gw(U),S=new YS(O),wt=new Pw(O,S),q=new Ww(O,S,ze,wt),ft=new Yw(O,q,S,wt,ze),ot=new $w(O,he,Kt),st=new Dw(Wt),at=new lE(U,R,Qt,he,wt,st),vt=new RE(U,Wt),Mt=new uE,nt=new _E(Qt),F=new Rw(U,R,Et,ft,g,l),gt=new ME(U,ft,he),$t=new PE(O,ze,he,Et),it=new Iw(O,Qt,ze),At=new Xw(O,Qt,ze),ze.programs=at.programs,U.capabilities=he,U.extensions=Qt,U.properties=Wt,U.renderLists=Mt,U.shadowMap=gt,U.state=Et,U.info=ze}y!==ai&&(k=new Jw(y,e.width,e.height,a,s,r));let ct=new yd(U,O);this.xr=ct,this.getContext=function(){return O},this.getContextAttributes=function(){return O.getContextAttributes()},this.forceContextLoss=function(){let w=Qt.get("WEBGL_lose_context");w&&w.loseContext()},this.forceContextRestore=function(){let w=Qt.get("WEBGL_lose_context");w&&w.restoreContext()},this.getPixelRatio=function(){return Tt},this.setPixelRatio=function(w){w!==void 0&&(Tt=w,this.setSize(St,Pt,!1))},this.getSize=function(w){return w.set(St,Pt)},this.setSize=function(w,B,Q=!0){if(ct.isPresenting){jt("WebGLRenderer: Can't change size while VR device is presenting.");return}St=w,Pt=B,e.width=Math.floor(w*Tt),e.height=Math.floor(B*Tt),Q===!0&&(e.style.width=w+"px",e.style.height=B+"px"),k!==null&&k.setSize(e.width,e.height),this.setViewport(0,0,w,B)},this.getDrawingBufferSize=function(w){return w.set(St*Tt,Pt*Tt).floor()},this.setDrawingBufferSize=function(w,B,Q){St=w,Pt=B,Tt=Q,e.width=Math.floor(w*Q),e.height=Math.floor(B*Q),this.setViewport(0,0,w,B)},this.setEffects=function(w){if(y===ai){se("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(w){for(let B=0;B<w.length;B++)if(w[B].isOutputPass===!0){jt("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}k.setEffects(w||[])},this.getCurrentViewport=function(w){return w.copy(rt)},this.getViewport=function(w){return w.copy(qt)},this.setViewport=function(w,B,Q,Y){w.isVector4?qt.set(w.x,w.y,w.z,w.w):qt.set(w,B,Q,Y),Et.viewport(rt.copy(qt).multiplyScalar(fn()).round())},this.getScissor=function(w){return w.copy(ge)},this.setScissor=function(w,B,Q,Y){w.isVector4?ge.set(w.x,w.y,w.z,w.w):ge.set(w,B,Q,Y),Et.scissor(pt.copy(ge).multiplyScalar(fn()).round())},this.getScissorTest=function(){return de},this.setScissorTest=function(w){Et.setScissorTest(de=w)},this.setOpaqueSort=function(w){Yt=w},this.setTransparentSort=function(w){ce=w},this.getClearColor=function(w){return w.copy(F.getClearColor())},this.setClearColor=function(){F.setClearColor(...arguments)},this.getClearAlpha=function(){return F.getClearAlpha()},this.setClearAlpha=function(){F.setClearAlpha(...arguments)},this.clear=function(w=!0,B=!0,Q=!0){let Y=0;if(w){let J=!1;if(ht!==null){let Ct=ht.texture.format;J=p.has(Ct)}if(J){let Ct=ht.texture.type,Dt=m.has(Ct),Rt=F.getClearColor(),Nt=F.getClearAlpha(),Gt=Rt.r,re=Rt.g,_e=Rt.b;Dt?(v[0]=Gt,v[1]=re,v[2]=_e,v[3]=Nt,O.clearBufferuiv(O.COLOR,0,v)):(C[0]=Gt,C[1]=re,C[2]=_e,C[3]=Nt,O.clearBufferiv(O.COLOR,0,C))}else Y|=O.COLOR_BUFFER_BIT}B&&(Y|=O.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),Q&&(Y|=O.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Y!==0&&O.clear(Y)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(w){w.setRenderer(this),z=w},this.dispose=function(){e.removeEventListener("webglcontextlost",zt,!1),e.removeEventListener("webglcontextrestored",ie,!1),e.removeEventListener("webglcontextcreationerror",It,!1),F.dispose(),Mt.dispose(),nt.dispose(),Kt.dispose(),Wt.dispose(),R.dispose(),ft.dispose(),q.dispose(),wt.dispose(),$t.dispose(),at.dispose(),ct.dispose(),ct.removeEventListener("sessionstart",al),ct.removeEventListener("sessionend",qi),fs.stop()};function zt(w){w.preventDefault(),ga("WebGLRenderer: Context Lost."),N=!0}function ie(){ga("WebGLRenderer: Context Restored."),N=!1;let w=ze.autoReset,B=gt.enabled,Q=gt.autoUpdate,Y=gt.needsUpdate,J=gt.type;ne(),ze.autoReset=w,gt.enabled=B,gt.autoUpdate=Q,gt.needsUpdate=Y,gt.type=J}function It(w){se("WebGLRenderer: A WebGL context could not be created. Reason: ",w.statusMessage)}function fe(w){let B=w.target;B.removeEventListener("dispose",fe),Xe(B)}function Xe(w){Xn(w),Wt.remove(w)}function Xn(w){let B=Wt.get(w).programs;B!==void 0&&(B.forEach(function(Q){at.releaseProgram(Q)}),w.isShaderMaterial&&at.releaseShaderCache(w))}this.renderBufferDirect=function(w,B,Q,Y,J,Ct){B===null&&(B=yn);let Dt=J.isMesh&&J.matrixWorld.determinantAffine()<0,Rt=Xo(w,B,Q,Y,J);Et.setMaterial(Y,Dt);let Nt=Q.index,Gt=1;if(Y.wireframe===!0){if(Nt=q.getWireframeAttribute(Q),Nt===void 0)return;Gt=2}let re=Q.drawRange,_e=Q.attributes.position,Vt=re.start*Gt,xe=(re.start+re.count)*Gt;Ct!==null&&(Vt=Math.max(Vt,Ct.start*Gt),xe=Math.min(xe,(Ct.start+Ct.count)*Gt)),Nt!==null?(Vt=Math.max(Vt,0),xe=Math.min(xe,Nt.count)):_e!=null&&(Vt=Math.max(Vt,0),xe=Math.min(xe,_e.count));let tn=xe-Vt;if(tn<0||tn===1/0)return;wt.setup(J,Y,Rt,Q,Nt);let Ue,Fe=it;if(Nt!==null&&(Ue=S.get(Nt),Fe=At,Fe.setIndex(Ue)),J.isMesh)Y.wireframe===!0?(Et.setLineWidth(Y.wireframeLinewidth*fn()),Fe.setMode(O.LINES)):Fe.setMode(O.TRIANGLES);else if(J.isLine){let vn=Y.linewidth;vn===void 0&&(vn=1),Et.setLineWidth(vn*fn()),J.isLineSegments?Fe.setMode(O.LINES):J.isLineLoop?Fe.setMode(O.LINE_LOOP):Fe.setMode(O.LINE_STRIP)}else J.isPoints?Fe.setMode(O.POINTS):J.isSprite&&Fe.setMode(O.TRIANGLES);if(J.isBatchedMesh)if(Qt.get("WEBGL_multi_draw"))Fe.renderMultiDraw(J._multiDrawStarts,J._multiDrawCounts,J._multiDrawCount);else{let vn=J._multiDrawStarts,Bt=J._multiDrawCounts,dn=J._multiDrawCount,Se=Nt?S.get(Nt).bytesPerElement:1,ps=Wt.get(Y).currentProgram.getUniforms();for(let pn=0;pn<dn;pn++)ps.setValue(O,"_gl_DrawID",pn),Fe.render(vn[pn]/Se,Bt[pn])}else if(J.isInstancedMesh)Fe.renderInstances(Vt,tn,J.count);else if(Q.isInstancedBufferGeometry){let vn=Q._maxInstanceCount!==void 0?Q._maxInstanceCount:1/0,Bt=Math.min(Q.instanceCount,vn);Fe.renderInstances(Vt,tn,Bt)}else Fe.render(Vt,tn)};function Go(w,B,Q,Y){z!==null&&w.isNodeMaterial&&z.setObject(Y,w),He===!0&&st.setState(w,Q,!1),w.transparent===!0&&w.side===oi&&w.forceSinglePass===!1?(w.side=ni,w.needsUpdate=!0,$i(w,B,Y),w.side=tr,w.needsUpdate=!0,$i(w,B,Y),w.side=oi):$i(w,B,Y)}this.compile=function(w,B,Q=null){Q===null&&(Q=w),z!==null&&z.renderStart(w,B,Q),A=nt.get(Q),A.init(B),T.push(A),Q.traverseVisible(function(J){J.isLight&&J.layers.test(B.layers)&&(A.pushLight(J),J.castShadow&&A.pushShadow(J))}),w!==Q&&w.traverseVisible(function(J){J.isLight&&J.layers.test(B.layers)&&(A.pushLight(J),J.castShadow&&A.pushShadow(J))}),A.setupLights(),z!==null&&z.updateLights(A.state.lightsArray),un=this.localClippingEnabled,He=st.init(this.clippingPlanes,un),He===!0&&st.setGlobalState(this.clippingPlanes,B),z!==null&&gt.render(A.state.shadowsArray,Q,B);let Y=new Set;return w.traverse(function(J){if(!(J.isMesh||J.isPoints||J.isLine||J.isSprite))return;let Ct=J.material;if(Ct)if(Array.isArray(Ct))for(let Dt=0;Dt<Ct.length;Dt++){let Rt=Ct[Dt];Go(Rt,Q,B,J),Y.add(Rt)}else Go(Ct,Q,B,J),Y.add(Ct)}),A=T.pop(),z!==null&&z.renderEnd(),Y},this.compileAsync=function(w,B,Q=null){let Y=this.compile(w,B,Q);return new Promise(J=>{function Ct(){if(Y.forEach(function(Dt){let Nt=Wt.get(Dt).currentProgram;(Nt===void 0||Nt.isReady())&&Y.delete(Dt)}),Y.size===0){J(w);return}setTimeout(Ct,10)}Qt.get("KHR_parallel_shader_compile")!==null?Ct():setTimeout(Ct,10)})};let Ir=null;function Pu(w){Ir&&Ir(w)}function al(){fs.stop()}function qi(){fs.start()}let fs=new P0;fs.setAnimationLoop(Pu),typeof self<"u"&&fs.setContext(self),this.setAnimationLoop=function(w){Ir=w,ct.setAnimationLoop(w),w===null?fs.stop():fs.start()},ct.addEventListener("sessionstart",al),ct.addEventListener("sessionend",qi),this.render=function(w,B){if(B!==void 0&&B.isCamera!==!0){se("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(N===!0)return;z!==null&&z.renderStart(w,B);let Q=ct.enabled===!0&&ct.isPresenting===!0,Y=k!==null&&(ht===null||Q)&&k.begin(U,ht);if(w.matrixWorldAutoUpdate===!0&&w.updateMatrixWorld(),B.parent===null&&B.matrixWorldAutoUpdate===!0&&B.updateMatrixWorld(),ct.enabled===!0&&ct.isPresenting===!0&&(k===null||k.isCompositing()===!1)&&(ct.cameraAutoUpdate===!0&&ct.updateCamera(B),B=ct.getCamera()),w.isScene===!0&&w.onBeforeRender(U,w,B,ht),A=nt.get(w,T.length),A.init(B),A.state.textureUnits=Kt.getTextureUnits(),T.push(A),Be.multiplyMatrices(B.projectionMatrix,B.matrixWorldInverse),B.isArrayCamera?Ke.setFromArrayCamera(B):ae.setFromProjectionMatrix(Be,Ti,B.reversedDepth),un=this.localClippingEnabled,He=st.init(this.clippingPlanes,un),P=Mt.get(w,x.length),P.init(),x.push(P),this.info.render.frame++,ct.enabled===!0&&ct.isPresenting===!0){let Dt=U.xr.getDepthSensingMesh();Dt!==null&&ds(Dt,B,-1/0,U.sortObjects)}ds(w,B,0,U.sortObjects),P.finish(),z!==null&&z.updateLights(A.state.lightsArray),U.sortObjects===!0&&P.sort(Yt,ce),en=ct.enabled===!1||ct.isPresenting===!1||ct.hasDepthSensing()===!1,en&&F.addToRenderList(P,w),this.info.autoReset===!0&&this.info.reset(),He===!0&&st.beginShadows();let J=A.state.shadowsArray;if(gt.render(J,w,B),He===!0&&st.endShadows(),(Y&&k.hasRenderPass())===!1){let Dt=P.opaque,Rt=P.transmissive;if(A.setupLights(),B.isArrayCamera){let Nt=B.cameras;if(Rt.length>0)for(let Gt=0,re=Nt.length;Gt<re;Gt++){let _e=Nt[Gt];Ri(Dt,Rt,w,_e)}en&&F.render(w);for(let Gt=0,re=Nt.length;Gt<re;Gt++){let _e=Nt[Gt];Ho(P,w,_e,_e.viewport)}}else Rt.length>0&&Ri(Dt,Rt,w,B),en&&F.render(w),Ho(P,w,B)}ht!==null&&H===0&&(Kt.updateMultisampleRenderTarget(ht),Kt.updateRenderTargetMipmap(ht)),Y&&k.end(U),w.isScene===!0&&w.onAfterRender(U,w,B),wt.resetDefaultState(),j=-1,tt=null,T.pop(),T.length>0?(A=T[T.length-1],Kt.setTextureUnits(A.state.textureUnits),He===!0&&st.setGlobalState(U.clippingPlanes,A.state.camera)):A=null,x.pop(),x.length>0?P=x[x.length-1]:P=null,z!==null&&z.renderEnd()};function ds(w,B,Q,Y){if(w.visible===!1)return;if(w.layers.test(B.layers)){if(w.isGroup)Q=w.renderOrder;else if(w.isLOD)w.autoUpdate===!0&&w.update(B);else if(w.isLight)A.pushLight(w),w.castShadow&&A.pushShadow(w);else if(w.isSprite){let Dt=B.isArrayCamera?Ke:ae;if(!w.frustumCulled||w.intersectsFrustum(Dt)){Y&&we.setFromMatrixPosition(w.matrixWorld).applyMatrix4(Be);let Rt=ft.update(w),Nt=w.material;Nt.visible&&P.push(w,Rt,Nt,Q,we.z,null,B)}}else if(w.isMesh||w.isLine||w.isPoints){let Dt=B.isArrayCamera?Ke:ae;if(!w.frustumCulled||w.intersectsFrustum(Dt)){let Rt=ft.update(w),Nt=w.material;if(Y&&(w.boundingSphere!==void 0?(w.boundingSphere===null&&w.computeBoundingSphere(),we.copy(w.boundingSphere.center)):(Rt.boundingSphere===null&&Rt.computeBoundingSphere(),we.copy(Rt.boundingSphere.center)),we.applyMatrix4(w.matrixWorld).applyMatrix4(Be)),Array.isArray(Nt)){let Gt=Rt.groups;for(let re=0,_e=Gt.length;re<_e;re++){let Vt=Gt[re],xe=Nt[Vt.materialIndex];xe&&xe.visible&&P.push(w,Rt,xe,Q,we.z,Vt,B)}}else Nt.visible&&P.push(w,Rt,Nt,Q,we.z,null,B)}}}let Ct=w.children;for(let Dt=0,Rt=Ct.length;Dt<Rt;Dt++)ds(Ct[Dt],B,Q,Y)}function Ho(w,B,Q,Y){let{opaque:J,transmissive:Ct,transparent:Dt}=w;A.setupLightsView(Q),He===!0&&st.setGlobalState(U.clippingPlanes,Q),Y&&Et.viewport(rt.copy(Y)),J.length>0&&nn(J,B,Q),Ct.length>0&&nn(Ct,B,Q),Dt.length>0&&nn(Dt,B,Q),Et.buffers.depth.setTest(!0),Et.buffers.depth.setMask(!0),Et.buffers.color.setMask(!0),Et.setPolygonOffset(!1)}function Ri(w,B,Q,Y){if((Q.isScene===!0?Q.overrideMaterial:null)!==null)return;if(A.state.transmissionRenderTarget[Y.id]===void 0){let Vt=Qt.has("EXT_color_buffer_half_float")||Qt.has("EXT_color_buffer_float");A.state.transmissionRenderTarget[Y.id]=new gi(1,1,{generateMipmaps:!0,type:Vt?zi:ai,minFilter:Cs,samples:Math.max(4,he.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Me.workingColorSpace})}let Ct=A.state.transmissionRenderTarget[Y.id],Dt=Y.viewport||rt;Ct.setSize(Dt.z*U.transmissionResolutionScale,Dt.w*U.transmissionResolutionScale);let Rt=U.getRenderTarget(),Nt=U.getActiveCubeFace(),Gt=U.getActiveMipmapLevel();U.setRenderTarget(Ct),U.getClearColor(et),xt=U.getClearAlpha(),xt<1&&U.setClearColor(16777215,.5),U.clear(),en&&F.render(Q);let re=U.toneMapping;U.toneMapping=ls;let _e=Y.viewport;if(Y.viewport!==void 0&&(Y.viewport=void 0),A.setupLightsView(Y),He===!0&&st.setGlobalState(U.clippingPlanes,Y),nn(w,Q,Y),Kt.updateMultisampleRenderTarget(Ct),Kt.updateRenderTargetMipmap(Ct),Qt.has("WEBGL_multisampled_render_to_texture")===!1){let Vt=!1;for(let xe=0,tn=B.length;xe<tn;xe++){let Ue=B[xe],{object:Fe,geometry:vn,material:Bt,group:dn}=Ue;if(Bt.side===oi&&Fe.layers.test(Y.layers)){let Se=Bt.side;Bt.side=ni,Bt.needsUpdate=!0,cn(Fe,Q,Y,vn,Bt,dn),Bt.side=Se,Bt.needsUpdate=!0,Vt=!0}}Vt===!0&&(Kt.updateMultisampleRenderTarget(Ct),Kt.updateRenderTargetMipmap(Ct))}U.setRenderTarget(Rt,Nt,Gt),U.setClearColor(et,xt),_e!==void 0&&(Y.viewport=_e),U.toneMapping=re}function nn(w,B,Q){let Y=B.isScene===!0?B.overrideMaterial:null;for(let J=0,Ct=w.length;J<Ct;J++){let Dt=w[J],{object:Rt,geometry:Nt,group:Gt}=Dt,re=Dt.material;re.allowOverride===!0&&Y!==null&&(re=Y),Rt.layers.test(Q.layers)&&cn(Rt,B,Q,Nt,re,Gt)}}function cn(w,B,Q,Y,J,Ct){z!==null&&J.isNodeMaterial&&z.setObject(w,J),w.onBeforeRender(U,B,Q,Y,J,Ct),w.modelViewMatrix.multiplyMatrices(Q.matrixWorldInverse,w.matrixWorld),w.normalMatrix.getNormalMatrix(w.modelViewMatrix),J.onBeforeRender(U,B,Q,Y,w,Ct),J.transparent===!0&&J.side===oi&&J.forceSinglePass===!1?(J.side=ni,J.needsUpdate=!0,U.renderBufferDirect(Q,B,Y,J,w,Ct),J.side=tr,J.needsUpdate=!0,U.renderBufferDirect(Q,B,Y,J,w,Ct),J.side=oi):U.renderBufferDirect(Q,B,Y,J,w,Ct),w.onAfterRender(U,B,Q,Y,J,Ct)}function hn(w){let B=0;for(let Q of w)Q.texture!==null&&B++;return B}function $i(w,B,Q){B.isScene!==!0&&(B=yn);let Y=Wt.get(w),J=A.state.lights,Ct=A.state.shadowsArray,Dt=J.state.version,Rt=at.getParameters(w,J.state,Ct,B,Q,A.state.lightProbeGridArray),Nt=at.getProgramCacheKey(Rt),Gt=Y.programs;Y.environment=w.isMeshStandardMaterial||w.isMeshLambertMaterial||w.isMeshPhongMaterial?B.environment:null,Y.fog=B.fog;let re=w.isMeshStandardMaterial||w.isMeshLambertMaterial&&!w.envMap||w.isMeshPhongMaterial&&!w.envMap;Y.envMap=R.get(w.envMap||Y.environment,re),Y.envMapRotation=Y.environment!==null&&w.envMap===null?B.environmentRotation:w.envMapRotation,Gt===void 0&&(w.addEventListener("dispose",fe),Gt=new Map,Y.programs=Gt,Y.programVariants=new Map);let _e=Gt.get(Nt);if(_e!==void 0){if(Y.currentProgram===_e&&Y.lightsStateVersion===Dt)return Wo(w,Rt),_e}else Rt.uniforms=at.getUniforms(w),z!==null&&w.isNodeMaterial&&z.build(w,Q,Rt),w.onBeforeCompile(Rt,U),_e=at.acquireProgram(Rt,Nt),Gt.set(Nt,_e),Y.uniforms=Rt.uniforms;let Vt=Y.uniforms;return(!w.isShaderMaterial&&!w.isRawShaderMaterial||w.clipping===!0)&&(Vt.clippingPlanes=st.uniform),Wo(w,Rt),Y.needsLights=Fs(w),Y.lightsStateVersion=Dt,Y.needsLights&&(Vt.ambientLightColor.value=J.state.ambient,Vt.lightProbe.value=J.state.probe,Vt.sunLights.value=J.state.sun,Vt.sunLightShadows.value=J.state.sunShadow,Vt.directionalLights.value=J.state.directional,Vt.directionalLightShadows.value=J.state.directionalShadow,Vt.spotLights.value=J.state.spot,Vt.spotLightShadows.value=J.state.spotShadow,Vt.rectAreaLights.value=J.state.rectArea,Vt.ltc_1.value=J.state.rectAreaLTC1,Vt.ltc_2.value=J.state.rectAreaLTC2,Vt.pointLights.value=J.state.point,Vt.pointLightShadows.value=J.state.pointShadow,Vt.hemisphereLights.value=J.state.hemi,Vt.sunShadowMatrix.value=J.state.sunShadowMatrix,Vt.sunShadowCascade.value=J.state.sunShadowCascade,Vt.directionalShadowMatrix.value=J.state.directionalShadowMatrix,Vt.spotLightMatrix.value=J.state.spotLightMatrix,Vt.spotLightMap.value=J.state.spotLightMap,Vt.pointShadowMatrix.value=J.state.pointShadowMatrix),Y.numLightProbeGrids=hn(A.state.lightProbeGridArray),Y.currentProgram=_e,Y.uniformsList=null,_e}function ci(w,B,Q,Y,J){let Ct=Wt.get(w),Dt=Ct.currentProgram.id+","+Y+","+J,Rt=Ct.programVariants.get(Dt);return Rt===void 0?(Rt=$i(w,B,Q),Ct.programVariants.set(Dt,Rt)):(Ct.currentProgram=Rt,Ct.uniformsList=null,Ct.outputColorSpace=Y,Ct.toneMapping=J),Rt}function Us(w){if(w.uniformsList===null){let B=w.currentProgram.getUniforms();w.uniformsList=Co.seqWithValue(B.seq,w.uniforms)}return w.uniformsList}function Wo(w,B){let Q=Wt.get(w);Q.outputColorSpace=B.outputColorSpace,Q.batching=B.batching,Q.batchingColor=B.batchingColor,Q.instancing=B.instancing,Q.instancingColor=B.instancingColor,Q.instancingMorph=B.instancingMorph,Q.skinning=B.skinning,Q.morphTargets=B.morphTargets,Q.morphNormals=B.morphNormals,Q.morphColors=B.morphColors,Q.morphTargetsCount=B.morphTargetsCount,Q.numClippingPlanes=B.numClippingPlanes,Q.numIntersection=B.numClipIntersection,Q.vertexAlphas=B.vertexAlphas,Q.vertexTangents=B.vertexTangents,Q.toneMapping=B.toneMapping}function Xo(w,B,Q,Y,J){B.isScene!==!0&&(B=yn),Kt.resetTextureUnits();let Ct=B.fog,Dt=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial?B.environment:null,Rt=ht===null?U.outputColorSpace:ht.isXRRenderTarget===!0?ht.texture.colorSpace:Me.workingColorSpace,Nt=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial&&!Y.envMap||Y.isMeshPhongMaterial&&!Y.envMap,Gt=R.get(Y.envMap||Dt,Nt),re=Y.vertexColors===!0&&!!Q.attributes.color&&Q.attributes.color.itemSize===4,_e=!!Q.attributes.tangent&&(!!Y.normalMap||Y.anisotropy>0),Vt=!!Q.morphAttributes.position,xe=!!Q.morphAttributes.normal,tn=!!Q.morphAttributes.color,Ue=ls;Y.toneMapped&&(ht===null||ht.isXRRenderTarget===!0)&&(Ue=U.toneMapping);let Fe=Q.morphAttributes.position||Q.morphAttributes.normal||Q.morphAttributes.color,vn=Fe!==void 0?Fe.length:0,Bt=Wt.get(Y),dn=A.state.lights;if(He===!0&&(un===!0||w!==tt)){let Oe=w===tt&&Y.id===j;st.setState(Y,w,Oe)}let Se=!1,ps=!1;Y.version===Bt.__version?Bt.needsLights&&Bt.lightsStateVersion!==dn.state.version||J.isBatchedMesh&&Bt.batching===!1||!J.isBatchedMesh&&Bt.batching===!0||J.isBatchedMesh&&Bt.batchingColor===!0&&J._colorsTexture===null||J.isBatchedMesh&&Bt.batchingColor===!1&&J._colorsTexture!==null||J.isInstancedMesh&&Bt.instancing===!1||!J.isInstancedMesh&&Bt.instancing===!0||J.isSkinnedMesh&&Bt.skinning===!1||!J.isSkinnedMesh&&Bt.skinning===!0||J.isInstancedMesh&&Bt.instancingColor===!0&&J.instanceColor===null||J.isInstancedMesh&&Bt.instancingColor===!1&&J.instanceColor!==null||J.isInstancedMesh&&Bt.instancingMorph===!0&&J.morphTexture===null||J.isInstancedMesh&&Bt.instancingMorph===!1&&J.morphTexture!==null||Bt.envMap!==Gt||Y.fog===!0&&Bt.fog!==Ct||Bt.numClippingPlanes!==void 0&&(Bt.numClippingPlanes!==st.numPlanes||Bt.numIntersection!==st.numIntersection)||Bt.vertexAlphas!==re||Bt.vertexTangents!==_e||Bt.morphTargets!==Vt||Bt.morphNormals!==xe||Bt.morphColors!==tn||Bt.morphTargetsCount!==vn||Bt.numLightProbeGrids!==hn(A.state.lightProbeGridArray)?Se=!0:(Bt.outputColorSpace!==Rt||Bt.toneMapping!==Ue)&&(ps=!0):(Se=!0,Bt.__version=Y.version);let pn=Bt.currentProgram;(Se===!0||ps===!0)&&(pn=ps===!0?ci(Y,B,J,Rt,Ue):$i(Y,B,J),z&&Y.isNodeMaterial&&z.onUpdateProgram(Y,pn,Bt));let Nr=!1,Yi=!1,ms=!1,pe=pn.getUniforms(),sn=Bt.uniforms;if(Et.useProgram(pn.program)&&(Nr=!0,Yi=!0,ms=!0),Y.id!==j&&(j=Y.id,Yi=!0),Nr||tt!==w){Et.buffers.depth.getReversed()&&w.reversedDepth!==!0&&(w._reversedDepth=!0,w.updateProjectionMatrix()),pe.setValue(O,"projectionMatrix",w.projectionMatrix),pe.setValue(O,"viewMatrix",w.matrixWorldInverse);let mn=pe.map.cameraPosition;mn!==void 0&&mn.setValue(O,Rn.setFromMatrixPosition(w.matrixWorld)),he.logarithmicDepthBuffer&&pe.setValue(O,"logDepthBufFC",2/(Math.log(w.far+1)/Math.LN2)),(Y.isMeshPhongMaterial||Y.isMeshToonMaterial||Y.isMeshLambertMaterial||Y.isMeshBasicMaterial||Y.isMeshStandardMaterial||Y.isShaderMaterial)&&pe.setValue(O,"isOrthographic",w.isOrthographicCamera===!0),tt!==w&&(tt=w,Yi=!0,ms=!0)}if(Bt.needsLights&&(dn.state.sunShadowMap.length>0&&pe.setValue(O,"sunShadowMap",dn.state.sunShadowMap,Kt),dn.state.directionalShadowMap.length>0&&pe.setValue(O,"directionalShadowMap",dn.state.directionalShadowMap,Kt),dn.state.spotShadowMap.length>0&&pe.setValue(O,"spotShadowMap",dn.state.spotShadowMap,Kt),dn.state.pointShadowMap.length>0&&pe.setValue(O,"pointShadowMap",dn.state.pointShadowMap,Kt)),J.isSkinnedMesh){pe.setOptional(O,J,"bindMatrix"),pe.setOptional(O,J,"bindMatrixInverse");let Oe=J.skeleton;Oe&&(Oe.boneTexture===null&&Oe.computeBoneTexture(),pe.setValue(O,"boneTexture",Oe.boneTexture,Kt))}J.isBatchedMesh&&(pe.setOptional(O,J,"batchingTexture"),pe.setValue(O,"batchingTexture",J._matricesTexture,Kt),pe.setOptional(O,J,"batchingIdTexture"),pe.setValue(O,"batchingIdTexture",J._indirectTexture,Kt),pe.setOptional(O,J,"batchingColorTexture"),J._colorsTexture!==null&&pe.setValue(O,"batchingColorTexture",J._colorsTexture,Kt));let qn=Q.morphAttributes;if((qn.position!==void 0||qn.normal!==void 0||qn.color!==void 0)&&ot.update(J,Q,pn),(Yi||Bt.receiveShadow!==J.receiveShadow)&&(Bt.receiveShadow=J.receiveShadow,pe.setValue(O,"receiveShadow",J.receiveShadow)),(Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial)&&Y.envMap===null&&B.environment!==null&&(sn.envMapIntensity.value=B.environmentIntensity),sn.dfgLUT!==void 0&&(sn.dfgLUT.value=LE()),Yi){if(pe.setValue(O,"toneMappingExposure",U.toneMappingExposure),Bt.needsLights&&Lr(sn,ms),Ct&&Y.fog===!0&&vt.refreshFogUniforms(sn,Ct),vt.refreshMaterialUniforms(sn,Y,Tt,Pt,A.state.transmissionRenderTarget[w.id]),Bt.needsLights&&Bt.numLightProbeGrids>0){let Oe=b,mn=0;for(let Vn of A.state.lightProbeGridArray)Vn.texture!==null&&(Oe.textures[mn]=Vn.texture,Oe.min[mn]=Vn.boundingBox.min,Oe.max[mn]=Vn.boundingBox.max,Oe.resolution[mn]=Vn.resolution,mn++);for(let Vn in Oe)Oe[Vn].length=mn;sn.probesSH.value=Oe.textures,sn.probesMin.value=Oe.min,sn.probesMax.value=Oe.max,sn.probesResolution.value=Oe.resolution}Co.upload(O,Us(Bt),sn,Kt)}if(Y.isShaderMaterial&&Y.uniformsNeedUpdate===!0&&(Co.upload(O,Us(Bt),sn,Kt),Y.uniformsNeedUpdate=!1),Y.isSpriteMaterial&&pe.setValue(O,"center",J.center),pe.setValue(O,"modelViewMatrix",J.modelViewMatrix),pe.setValue(O,"normalMatrix",J.normalMatrix),pe.setValue(O,"modelMatrix",J.matrixWorld),Y.uniformsGroups!==void 0){let Oe=Y.uniformsGroups;for(let mn=0,Vn=Oe.length;mn<Vn;mn++){let ll=Oe[mn];$t.update(ll,pn),$t.bind(ll,pn)}}return pn}function Lr(w,B){w.ambientLightColor.needsUpdate=B,w.lightProbe.needsUpdate=B,w.sunLights.needsUpdate=B,w.sunLightShadows.needsUpdate=B,w.directionalLights.needsUpdate=B,w.directionalLightShadows.needsUpdate=B,w.pointLights.needsUpdate=B,w.pointLightShadows.needsUpdate=B,w.spotLights.needsUpdate=B,w.spotLightShadows.needsUpdate=B,w.rectAreaLights.needsUpdate=B,w.hemisphereLights.needsUpdate=B}function Fs(w){return w.isMeshLambertMaterial||w.isMeshToonMaterial||w.isMeshPhongMaterial||w.isMeshStandardMaterial||w.isShadowMaterial||w.isShaderMaterial&&w.lights===!0}this.getActiveCubeFace=function(){return Z},this.getActiveMipmapLevel=function(){return H},this.getRenderTarget=function(){return ht},this.setRenderTargetTextures=function(w,B,Q){let Y=Wt.get(w);Y.__autoAllocateDepthBuffer=w.resolveDepthBuffer===!1,Y.__autoAllocateDepthBuffer===!1&&(Y.__useRenderToTexture=!1),Wt.get(w.texture).__webglTexture=B,Wt.get(w.depthTexture).__webglTexture=Y.__autoAllocateDepthBuffer?void 0:Q,Y.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(w,B){let Q=Wt.get(w);Q.__webglFramebuffer=B,Q.__useDefaultFramebuffer=B===void 0},this.setRenderTarget=function(w,B=0,Q=0){ht=w,Z=B,H=Q;let Y=null,J=!1,Ct=!1;if(w){let Rt=Wt.get(w);if(Rt.__useDefaultFramebuffer!==void 0){Et.bindFramebuffer(O.FRAMEBUFFER,Rt.__webglFramebuffer),rt.copy(w.viewport),pt.copy(w.scissor),dt=w.scissorTest,Et.viewport(rt),Et.scissor(pt),Et.setScissorTest(dt),j=-1;return}else if(Rt.__webglFramebuffer===void 0)Kt.setupRenderTarget(w);else if(Rt.__hasExternalTextures)Kt.rebindTextures(w,Wt.get(w.texture).__webglTexture,Wt.get(w.depthTexture).__webglTexture);else if(w.depthBuffer){let re=w.depthTexture;if(Rt.__boundDepthTexture!==re){if(re!==null&&Wt.has(re)&&(w.width!==re.image.width||w.height!==re.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Kt.setupDepthRenderbuffer(w)}}let Nt=w.texture;(Nt.isData3DTexture||Nt.isDataArrayTexture||Nt.isCompressedArrayTexture)&&(Ct=!0);let Gt=Wt.get(w).__webglFramebuffer;w.isWebGLCubeRenderTarget?(Array.isArray(Gt[B])?Y=Gt[B][Q]:Y=Gt[B],J=!0):w.samples>0&&Kt.useMultisampledRTT(w)===!1?Y=Wt.get(w).__webglMultisampledFramebuffer:Array.isArray(Gt)?Y=Gt[Q]:Y=Gt,rt.copy(w.viewport),pt.copy(w.scissor),dt=w.scissorTest}else rt.copy(qt).multiplyScalar(Tt).floor(),pt.copy(ge).multiplyScalar(Tt).floor(),dt=de;if(Q!==0&&(Y=W),Et.bindFramebuffer(O.FRAMEBUFFER,Y)&&Et.drawBuffers(w,Y),Et.viewport(rt),Et.scissor(pt),Et.setScissorTest(dt),J){let Rt=Wt.get(w.texture);O.framebufferTexture2D(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_CUBE_MAP_POSITIVE_X+B,Rt.__webglTexture,Q)}else if(Ct){let Rt=B;for(let Nt=0;Nt<w.textures.length;Nt++){let Gt=Wt.get(w.textures[Nt]);O.framebufferTextureLayer(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0+Nt,Gt.__webglTexture,Q,Rt)}}else if(w!==null&&Q!==0){let Rt=Wt.get(w.texture);O.framebufferTexture2D(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,Rt.__webglTexture,Q)}j=-1};function Dr(w){let B=Wt.get(w);return(B.__readFormat!==w.format||B.__readType!==w.type)&&(B.__readFormat=w.format,B.__readType=w.type,B.__formatReadable=he.textureFormatReadable(w.format),B.__typeReadable=he.textureTypeReadable(w.type)),B}this.readRenderTargetPixels=function(w,B,Q,Y,J,Ct,Dt,Rt=0){if(!(w&&w.isWebGLRenderTarget)){se("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Nt=Wt.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&Dt!==void 0&&(Nt=Nt[Dt],Array.isArray(Nt)&&(Nt=Nt[0])),Nt){Et.bindFramebuffer(O.FRAMEBUFFER,Nt);try{let Gt=w.textures[Rt],re=Gt.format,_e=Gt.type;w.textures.length>1&&O.readBuffer(O.COLOR_ATTACHMENT0+Rt);let Vt=Dr(Gt);if(Vt.__formatReadable===!1){se("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Vt.__typeReadable===!1){se("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}B>=0&&B<=w.width-Y&&Q>=0&&Q<=w.height-J&&O.readPixels(B,Q,Y,J,yt.convert(re),yt.convert(_e),Ct)}finally{let Gt=ht!==null?Wt.get(ht).__webglFramebuffer:null;Et.bindFramebuffer(O.FRAMEBUFFER,Gt)}}},this.readRenderTargetPixelsAsync=async function(w,B,Q,Y,J,Ct,Dt,Rt=0){if(!(w&&w.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Nt=Wt.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&Dt!==void 0&&(Nt=Nt[Dt],Array.isArray(Nt)&&(Nt=Nt[0])),Nt)if(B>=0&&B<=w.width-Y&&Q>=0&&Q<=w.height-J){Et.bindFramebuffer(O.FRAMEBUFFER,Nt);let Gt=w.textures[Rt],re=Gt.format,_e=Gt.type;w.textures.length>1&&O.readBuffer(O.COLOR_ATTACHMENT0+Rt);let Vt=Dr(Gt);if(Vt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Vt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let xe=O.createBuffer();O.bindBuffer(O.PIXEL_PACK_BUFFER,xe),O.bufferData(O.PIXEL_PACK_BUFFER,Ct.byteLength,O.STREAM_READ),O.readPixels(B,Q,Y,J,yt.convert(re),yt.convert(_e),0),O.bindBuffer(O.PIXEL_PACK_BUFFER,null);let tn=ht!==null?Wt.get(ht).__webglFramebuffer:null;Et.bindFramebuffer(O.FRAMEBUFFER,tn);let Ue=O.fenceSync(O.SYNC_GPU_COMMANDS_COMPLETE,0);return O.flush(),await n0(O,Ue,4),O.bindBuffer(O.PIXEL_PACK_BUFFER,xe),O.getBufferSubData(O.PIXEL_PACK_BUFFER,0,Ct),O.bindBuffer(O.PIXEL_PACK_BUFFER,null),O.deleteBuffer(xe),O.deleteSync(Ue),Ct}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(w,B=null,Q=0){let Y=Math.pow(2,-Q),J=Math.floor(w.image.width*Y),Ct=Math.floor(w.image.height*Y),Dt=B!==null?B.x:0,Rt=B!==null?B.y:0;Kt.setTexture2D(w,0),O.copyTexSubImage2D(O.TEXTURE_2D,Q,0,0,Dt,Rt,J,Ct),Et.unbindTexture()},this.copyTextureToTexture=function(w,B,Q=null,Y=null,J=0,Ct=0){let Dt,Rt,Nt,Gt,re,_e,Vt,xe,tn,Ue=w.isCompressedTexture?w.mipmaps[Ct]:w.image;if(Q!==null)Dt=Q.max.x-Q.min.x,Rt=Q.max.y-Q.min.y,Nt=Q.isBox3?Q.max.z-Q.min.z:1,Gt=Q.min.x,re=Q.min.y,_e=Q.isBox3?Q.min.z:0;else{let pe=Math.pow(2,-J);Dt=Math.floor(Ue.width*pe),Rt=Math.floor(Ue.height*pe),w.isDataArrayTexture?Nt=Ue.depth:w.isData3DTexture?Nt=Math.floor(Ue.depth*pe):Nt=1,Gt=0,re=0,_e=0}Y!==null?(Vt=Y.x,xe=Y.y,tn=Y.z):(Vt=0,xe=0,tn=0);let Fe=yt.convert(B.format),vn=yt.convert(B.type),Bt;B.isData3DTexture?(Kt.setTexture3D(B,0),Bt=O.TEXTURE_3D):B.isDataArrayTexture||B.isCompressedArrayTexture?(Kt.setTexture2DArray(B,0),Bt=O.TEXTURE_2D_ARRAY):(Kt.setTexture2D(B,0),Bt=O.TEXTURE_2D),Et.activeTexture(O.TEXTURE0),Et.pixelStorei(O.UNPACK_FLIP_Y_WEBGL,B.flipY),Et.pixelStorei(O.UNPACK_PREMULTIPLY_ALPHA_WEBGL,B.premultiplyAlpha),Et.pixelStorei(O.UNPACK_ALIGNMENT,B.unpackAlignment);let dn=Et.getParameter(O.UNPACK_ROW_LENGTH),Se=Et.getParameter(O.UNPACK_IMAGE_HEIGHT),ps=Et.getParameter(O.UNPACK_SKIP_PIXELS),pn=Et.getParameter(O.UNPACK_SKIP_ROWS),Nr=Et.getParameter(O.UNPACK_SKIP_IMAGES);Et.pixelStorei(O.UNPACK_ROW_LENGTH,Ue.width),Et.pixelStorei(O.UNPACK_IMAGE_HEIGHT,Ue.height),Et.pixelStorei(O.UNPACK_SKIP_PIXELS,Gt),Et.pixelStorei(O.UNPACK_SKIP_ROWS,re),Et.pixelStorei(O.UNPACK_SKIP_IMAGES,_e);let Yi=w.isDataArrayTexture||w.isData3DTexture,ms=B.isDataArrayTexture||B.isData3DTexture;if(w.isDepthTexture){let pe=Wt.get(w),sn=Wt.get(B),qn=Wt.get(pe.__renderTarget),Oe=Wt.get(sn.__renderTarget);Et.bindFramebuffer(O.READ_FRAMEBUFFER,qn.__webglFramebuffer),Et.bindFramebuffer(O.DRAW_FRAMEBUFFER,Oe.__webglFramebuffer);for(let mn=0;mn<Nt;mn++)Yi&&(O.framebufferTextureLayer(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,Wt.get(w).__webglTexture,J,_e+mn),O.framebufferTextureLayer(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,Wt.get(B).__webglTexture,Ct,tn+mn)),O.blitFramebuffer(Gt,re,Gt+Dt,re+Rt,Vt,xe,Vt+Dt,xe+Rt,O.DEPTH_BUFFER_BIT,O.NEAREST);Et.bindFramebuffer(O.READ_FRAMEBUFFER,null),Et.bindFramebuffer(O.DRAW_FRAMEBUFFER,null)}else if(J!==0||w.isRenderTargetTexture||Wt.has(w)){let pe=Wt.get(w),sn=Wt.get(B);Et.bindFramebuffer(O.READ_FRAMEBUFFER,D),Et.bindFramebuffer(O.DRAW_FRAMEBUFFER,X);for(let qn=0;qn<Nt;qn++)Yi?O.framebufferTextureLayer(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,pe.__webglTexture,J,_e+qn):O.framebufferTexture2D(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,pe.__webglTexture,J),ms?O.framebufferTextureLayer(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,sn.__webglTexture,Ct,tn+qn):O.framebufferTexture2D(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,sn.__webglTexture,Ct),J!==0?O.blitFramebuffer(Gt,re,Gt+Dt,re+Rt,Vt,xe,Vt+Dt,xe+Rt,O.COLOR_BUFFER_BIT,O.NEAREST):ms?O.copyTexSubImage3D(Bt,Ct,Vt,xe,tn+qn,Gt,re,Dt,Rt):O.copyTexSubImage2D(Bt,Ct,Vt,xe,Gt,re,Dt,Rt);Et.bindFramebuffer(O.READ_FRAMEBUFFER,null),Et.bindFramebuffer(O.DRAW_FRAMEBUFFER,null)}else ms?w.isDataTexture||w.isData3DTexture?O.texSubImage3D(Bt,Ct,Vt,xe,tn,Dt,Rt,Nt,Fe,vn,Ue.data):B.isCompressedArrayTexture?O.compressedTexSubImage3D(Bt,Ct,Vt,xe,tn,Dt,Rt,Nt,Fe,Ue.data):O.texSubImage3D(Bt,Ct,Vt,xe,tn,Dt,Rt,Nt,Fe,vn,Ue):w.isDataTexture?O.texSubImage2D(O.TEXTURE_2D,Ct,Vt,xe,Dt,Rt,Fe,vn,Ue.data):w.isCompressedTexture?O.compressedTexSubImage2D(O.TEXTURE_2D,Ct,Vt,xe,Ue.width,Ue.height,Fe,Ue.data):O.texSubImage2D(O.TEXTURE_2D,Ct,Vt,xe,Dt,Rt,Fe,vn,Ue);Et.pixelStorei(O.UNPACK_ROW_LENGTH,dn),Et.pixelStorei(O.UNPACK_IMAGE_HEIGHT,Se),Et.pixelStorei(O.UNPACK_SKIP_PIXELS,ps),Et.pixelStorei(O.UNPACK_SKIP_ROWS,pn),Et.pixelStorei(O.UNPACK_SKIP_IMAGES,Nr),Ct===0&&B.generateMipmaps===!0&&B.mipmapsAutoUpdate===!0&&O.generateMipmap(Bt),Et.unbindTexture()},this.initRenderTarget=function(w){Wt.get(w).__webglFramebuffer===void 0&&Kt.setupRenderTarget(w)},this.initTexture=function(w){w.isCubeTexture?Kt.setTextureCube(w,0):w.isData3DTexture?Kt.setTexture3D(w,0):w.isDataArrayTexture||w.isCompressedArrayTexture?Kt.setTexture2DArray(w,0):Kt.setTexture2D(w,0),Et.unbindTexture()},this.resetState=function(){Z=0,H=0,ht=null,Et.reset(),wt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Ti}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=Me._getDrawingBufferColorSpace(t),e.unpackColorSpace=Me._getUnpackColorSpace()}};function V0(i,t){let e={servo:"",operation:"",pursued:!1},n=()=>t(e.pursued?e.servo||e.operation:"");i.follow("(servo ?state ?object ?x ?y ?d)",s=>{e.servo=s.length?$(ut(s[0])[2]):"",n()}),i.follow("(operation ?i ?operation ?state)",s=>{let[,,r,o]=s.length?ut(s[0]):[];e.operation=$(o)==="running"?$(r.at(-1)):"",n()}),i.follow("(goal-state ?n ?state ?detail)",s=>{e.pursued=s.some(r=>$(ut(r)[2])==="running"),n()})}var Yh=class{line=new vo(new an().setFromPoints([new G,new G]),new Ia({color:15901498,dashSize:14,gapSize:9}));show(t,e){if(this.line.visible=!!(t&&e),!t||!e)return;let n=[t,e].flatMap(s=>[s.x,s.y,s.z]);this.line.geometry.setAttribute("position",new Re(n,3)),this.line.computeLineDistances()}};var DE=50,NE=2,vd=DE*NE,G0=.04,UE=new xr(1,20,14),FE=new ss({color:7127295,depthTest:!1,transparent:!0,opacity:.75});function OE([i,t,e,n,s,r]){let o=Math.sqrt(i),[a,l]=[t/o,e/o],c=Math.sqrt(n-a*a),h=(s-a*l)/c,u=Math.sqrt(r-l*l-h*h);return[o,c,u].every(f=>f>0)?[[o,a,l],[0,c,h],[0,0,u]]:null}function BE({spread:i,covariance:t},{eye:e,right:n,down:s,ahead:r},o){let a=t&&OE(t);if(a){let u=([f,d,g])=>new G().addScaledVector(n,f).addScaledVector(s,d).addScaledVector(r,g);return[u(a[0]),u(a[1]),u(a[2])]}if(i===void 0||!(i>0))return null;let l=new G().subVectors(o,e).normalize(),c=new G().crossVectors(l,s).normalize(),h=new G().crossVectors(l,c);return[l.multiplyScalar(i),c.multiplyScalar(G0),h.multiplyScalar(G0)]}var Zh=class{mesh=new bn(UE,FE);constructor(){this.mesh.matrixAutoUpdate=!1,this.mesh.visible=!1}show(t,e,n){let s=t&&e&&n?BE(t,e,n):null;if(this.mesh.visible=s!==null,!s)return;let[r,o,a]=s;this.mesh.matrix=new De().makeBasis(r,o,a).scale(new G(vd,vd,vd)),this.mesh.matrixWorldNeedsUpdate=!0}};var kE=160,Jh="end-effector",zE=.45,Sd={circle:i=>i.arc(64,64,34,0,2*Math.PI),square:i=>i.rect(33,33,62,62),triangle:i=>H0(i,[[64,26],[102,96],[26,96]]),cross:i=>H0(i,[[52,26],[76,26],[76,52],[102,52],[102,76],[76,76],[76,102],[52,102],[52,76],[26,76],[26,52],[52,52]])};function H0(i,t){t.forEach(([e,n],s)=>s?i.lineTo(e,n):i.moveTo(e,n)),i.closePath()}function W0(i,t,e){let n=document.createElement("canvas");n.width=i,n.height=t,e(Qi(n));let s=new Ta(n);return s.colorSpace=Kn,s}function VE(i){return W0(128,128,t=>{let[e,n]=i===Jh?["#14181b","#f4f6f7"]:["#f4f6f7","#14181b"];t.fillStyle=e,t.fillRect(0,0,128,128),t.fillStyle=n,t.beginPath();let s=i===Jh?Sd.triangle:Object.hasOwn(Sd,i)?Sd[i]:null;s&&s(t),t.fill(),!s&&(t.font="bold 64px system-ui, sans-serif",t.textAlign="center",t.fillText(i.slice(0,1).toUpperCase(),64,86))})}function GE(i){return W0(256,64,t=>{t.font="600 34px system-ui, sans-serif",t.textAlign="center",t.lineWidth=7,t.strokeStyle="#0e171e";let e=i.length>14?`${i.slice(0,13)}\u2026`:i;t.strokeText(e,128,44),t.fillStyle="#ffffff",t.fillText(e,128,44)})}var Kh=class{group=new kn;#t;#e=null;#n=null;#i=0;#s;#r=new Zh;#o;constructor(t,e){this.#t=e;let n=new as({color:15133420,roughness:.8}),s=VE(t);s.center.set(.5,.5),s.rotation=Math.PI/2;let r=new as({map:s,roughness:.8}),o=t===Jh?4:e,a=t===Jh?e*.7:e,l=new bn(new _i(o,a,a),[r,n,n,n,n,n]);l.position.setX(-o/2);let c=new ba(new yo({map:GE(t),depthTest:!1}));c.scale.set(e*2.4,e*.6,1),c.position.set(-e/2,0,e*.85),this.#s=[n,r],this.#o=new bn(new Pa(e*.85,e*.97,40),new ss({color:15901498,side:oi,transparent:!0})),this.#o.position.set(-o/2,0,-a/2+2),this.#o.visible=!1,this.group.add(l,c,this.#r.mesh,this.#o)}believe(t,e){let n=t&&!["seen","found"].includes(t.state);for(let s of this.#s)s.opacity=n?zE:1,s.transparent=!!n;this.#r.show(t,e,this.#n)}hasSpread(){return this.#r.mesh.visible}mark(t){this.#o.visible=t}goTo(t,e,n){let s=new G(t,e,n);this.#e=this.#n?this.group.position.clone():s,this.#n=s,this.#i=performance.now()}step(){let t=Math.min((performance.now()-this.#i)/kE,1);return this.#e&&this.#n&&this.group.position.lerpVectors(this.#e,this.#n,t),t<1}top(){return this.group.position.clone().add(new G(-this.#t/2,0,this.#t/2))}};var HE=64,jh=class{#t;#e=60;#n="";#i=new Map;#s=null;#r=new Map;group=new kn;constructor(t,e){this.#t=e,t.follow("(place ?name ?x ?y ?z ?frame)",n=>this.#o(n))}setCell({cube:t}){this.#e=t}believe(t,e){this.#i=t,this.#s=e;for(let[n,s]of this.#r)s.believe(t.get(n),e);this.#t.says("spread",[...this.#r.values()].filter(n=>n.hasSpread()).length)}mark(t){this.#n=t;for(let[e,n]of this.#r)n.mark(e===t);this.#t.says("target",this.#r.has(t)?t:""),this.#t.ask()}step(){return[...this.#r.values()].map(t=>t.step()).includes(!0)}topOfTarget(){return this.#r.get(this.#n)?.top()}#o(t){let e=new Map(t.map(n=>[$(ut(n)[1]),ut(n)]));for(let[n,s]of this.#r)e.has(n)||(this.group.remove(s.group),this.#r.delete(n));for(let[n,s]of e)this.#a(n,s);this.believe(this.#i,this.#s),this.mark(this.#n)}#a(t,[,,e,n,s]){let r=this.#r.get(t);if(!r){if(this.#r.size>=HE)return;r=new Kh(t,this.#e),this.#r.set(t,r),this.group.add(r.group)}r.goTo(e,n,s)}};var Md=i=>i*Math.PI/180;function X0({at:i,pan:t,tilt:e,roll:n},s){let[r,o]=[Md(t+s.pan),Md(e+s.tilt)],a=new G(-Math.cos(r)*Math.cos(o),Math.sin(r)*Math.cos(o),Math.sin(o)),l=new G(Math.sin(r),Math.cos(r),0).applyAxisAngle(a,Md(n));return{eye:new G(...i),right:l,down:new G().crossVectors(a,l),ahead:a}}var bd=320;function WE({eye:i,right:t,down:e,ahead:n},s){let[,,r,o,a]=s,l=(u,f)=>i.clone().addScaledVector(n,bd).addScaledVector(t,u*bd*r/2/a).addScaledVector(e,f*bd*o/2/a),c=[l(-1,-1),l(1,-1),l(1,1),l(-1,1)],h=c.flatMap((u,f)=>[i,u,u,c[(f+1)%4]]);return new rs(new an().setFromPoints(h),new Ei({color:5223423,transparent:!0,opacity:.6}))}var XE={pan:0,tilt:0},Qh=class{#t;#e;#n=null;#i=null;#s=null;#r=null;#o=null;frame=null;constructor(t,e,n){this.#t=e,this.#e=n;let s=(r,o)=>t.follow(r,a=>{o(a.length?ut(a[0]):null),this.#a()});s("(camera-model ?eyes ?width ?height ?focal ?cx ?cy ?base)",r=>this.#s=r),s("(head ?pan ?tilt ?state)",r=>this.#r=r&&{pan:r[1],tilt:r[2]}),s("(camera-pose ?x ?y ?z ?pan ?tilt ?roll ?state ?spread ?guess)",r=>{this.#i=r&&{at:[r[1],r[2],r[3]],pan:r[4],tilt:r[5],roll:r[6]}})}setCell({camera:t}){this.#n=t,this.#a()}#a(){this.#o&&this.#t.scene.remove(this.#o);let t=this.#n&&{...this.#n,...this.#i},e=t?.head?this.#r:XE;this.frame=t&&e?X0(t,e):null,this.#o=this.frame&&this.#s&&this.#s[4]>0?WE(this.frame,this.#s):null,this.#o&&this.#t.scene.add(this.#o),this.#t.says("camera",!!this.#o),this.#e(),this.#t.ask()}};var q0=110,qE=new as({color:15311419,roughness:.55,metalness:.1}),wd=new as({color:4411740,roughness:.5,metalness:.35}),$0=new as({color:11122626,roughness:.4,metalness:.5}),$E=new G(0,1,0),YE=i=>[...i.points,i.grip,i.approach,i.closing].flat(),tu=class{group=new kn;grip=null;#t=null;#e=[];#n=[];#i=0;#s=80;goTo(t){let e=YE(t);this.#t??=this.#a(t.points.length),this.#e=this.#n.length===e.length?this.#r():e,this.#n=e,this.#i=performance.now()}open(t){return t===void 0||t===this.#s?!1:(this.#s=t,!0)}step(){return this.#t?(this.#c(this.#t,this.#r()),performance.now()-this.#i<q0):!1}#r(){let t=Math.min((performance.now()-this.#i)/q0,1);return this.#n.map((e,n)=>this.#e[n]+(e-this.#e[n])*t)}#o(t,e){let n=new bn(t,e);return this.group.add(n),n}#a(t){let e=a=>58-30*(a/Math.max(t-1,1)),n=[];for(let a=0;a+1<t;++a)n.push(this.#o(new _r(e(a+1)*.8,e(a)*.8,1,24),qE));let s=[];for(let a=0;a<t;++a)s.push(this.#o(new xr(e(a),24,16),wd));let r=()=>this.#o(new _i(9,24,52),$0),o=this.#o(new _r(95,110,24,40),wd);return o.rotation.x=Math.PI/2,{links:n,joints:s,foot:o,stem:this.#o(new _r(16,20,1,20),$0),palm:this.#o(new _i(1,34,18),wd),fingers:[r(),r()]}}#l(t,e,n){let s=n.clone().sub(e);t.visible=s.length()>1,t.position.copy(e).addScaledVector(s,.5),t.scale.set(1,Math.max(s.length(),1),1),t.quaternion.setFromUnitVectors($E,s.normalize())}#c(t,e){let n=[];for(let y=0;y<e.length;y+=3)n.push(new G(e[y],e[y+1],e[y+2]));let[s,r,o]=n.splice(-3),{links:a,joints:l,foot:c,stem:h,palm:u,fingers:f}=t;c.position.copy(n[0]).setZ(12),a.forEach((y,p)=>this.#l(y,n[p],n[p+1])),l.forEach((y,p)=>y.position.copy(n[p])),this.grip=s;let d=new ti().setFromRotationMatrix(new De().makeBasis(o,new G().crossVectors(r,o),r)),g=s.clone().addScaledVector(r,-58);this.#l(h,n[n.length-1],g),u.position.copy(g),u.quaternion.copy(d),u.scale.setX(this.#s+26),f.forEach((y,p)=>{y.position.copy(s).addScaledVector(r,-26).addScaledVector(o,(p?1:-1)*(this.#s/2+5)),y.quaternion.copy(d)})}};var ZE=1.5,eu=class{group=new kn;constructor({parts:t}){let e=(l,c)=>{let h=2*Math.PI*l/t.length;return[c*Math.cos(h),c*Math.sin(h),ZE]},n=[],s=[];t.forEach(([l,c],h)=>{let u=(h+1)%t.length,[f,d]=t[u];if(c===0||d===0)return;let[g,y,p,m]=[e(h,l),e(h,c),e(u,d),e(u,f)];n.push(...g,...y,...p,...g,...p,...m),s.push(...y,...p,...g,...m)});let r=new an().setAttribute("position",new Re(n,3)),o=new an().setAttribute("position",new Re(s,3)),a={color:8376715,transparent:!0,opacity:.07,side:oi,depthWrite:!1};this.group.add(new bn(r,new ss(a)),new rs(o,new Ei({color:5214043})))}standAt([t,e]){this.group.position.set(t,e,0)}};var nu=class{#t;#e="";#n={};#i=new Map;#s=null;#r=null;constructor(t){this.#t=t}get grip(){return this.#s?.grip}setCell({reaches:t}){this.#n=t}choose(t){this.#e=t;for(let n of[this.#s,this.#r])n&&this.#t.scene.remove(n.group);this.#s=null,this.#r=this.#n[t]?new eu(this.#n[t]):null,this.#r&&this.#t.scene.add(this.#r.group),this.#t.says("reach",!!this.#r),this.#t.says("arm",t);let e=this.#i.get(t);e&&this.#o(e),this.#t.ask()}move(t){this.#i.set(t.arm,t),t.arm===this.#e&&this.#o(t)}open(t){this.#s?.open(t)&&this.#t.ask()}step(){return this.#s?.step()??!1}#o(t){this.#s||(this.#s=new tu,this.#t.scene.add(this.#s.group)),this.#s.goTo(t),this.#r?.standAt(t.points[0]),this.#t.ask()}};var JE=[0,1,2,6,7,11],KE=21;function Y0(i){let t=o=>i.filter(Array.isArray).find(a=>$(a[0])===o)??[],[,e,n]=t("range"),s=t("pose")[7],r=Array.isArray(s)&&s.length===KE&&s.every(Number.isFinite);return{range:e,spread:n,covariance:r?JE.map(o=>s[o]):void 0}}function Z0(i,t,e){let n=i.get(t);(!n||(n.confidence??0)<(e.confidence??0))&&i.set(t,e)}function jE(i,t){let e=new Map;for(let[,,,,s]of i.map(ut))for(let[r,o,...a]of s){let l=typeof a[0]=="number"?a[0]:void 0;Z0(e,$(r),{state:$(o),confidence:l,...Y0(a)})}let n=new Set(e.keys());for(let[,,s,,r,,,,o]of t.map(ut))n.has($(s))||Z0(e,$(s),{state:"found",confidence:r,...Y0(o)});return e}function J0(i,t){let e={looks:[],found:[]},n=(s,r)=>i.follow(r,o=>{e[s]=o,t(jE(e.looks,e.found))});n("looks","(look ?eyes ?frame ?text ?of)"),n("found","(found ?eyes ?name ?frame ?confidence ?second ?margin ?others ?places)")}var K0={type:"change"},Ed={type:"start"},Q0={type:"end"},iu=new gr,j0=new mi,QE=Math.cos(70*rd.DEG2RAD),En=new G,li=2*Math.PI,Pe={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Td=1e-6,su=class extends ka{constructor(t,e=null){super(t,e),this.state=Pe.NONE,this.target=new G,this.cursor=new G,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:js.ROTATE,MIDDLE:js.DOLLY,RIGHT:js.PAN},this.touches={ONE:Qs.ROTATE,TWO:Qs.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new G,this._lastQuaternion=new ti,this._lastTargetPosition=new G,this._quat=new ti().setFromUnitVectors(t.up,new G(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new bo,this._sphericalDelta=new bo,this._scale=1,this._panOffset=new G,this._rotateStart=new Jt,this._rotateEnd=new Jt,this._rotateDelta=new Jt,this._panStart=new Jt,this._panEnd=new Jt,this._panDelta=new Jt,this._dollyStart=new Jt,this._dollyEnd=new Jt,this._dollyDelta=new Jt,this._dollyDirection=new G,this._mouse=new Jt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=e1.bind(this),this._onPointerDown=t1.bind(this),this._onPointerUp=n1.bind(this),this._onContextMenu=c1.bind(this),this._onMouseWheel=r1.bind(this),this._onKeyDown=o1.bind(this),this._onTouchStart=a1.bind(this),this._onTouchMove=l1.bind(this),this._onMouseDown=i1.bind(this),this._onMouseMove=s1.bind(this),this._interceptControlDown=h1.bind(this),this._interceptControlUp=u1.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Pe.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(K0),this.update(),this.state=Pe.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;En.copy(e).sub(this.target),En.applyQuaternion(this._quat),this._spherical.setFromVector3(En),this.autoRotate&&this.state===Pe.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=li:n>Math.PI&&(n-=li),s<-Math.PI?s+=li:s>Math.PI&&(s-=li),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(En.setFromSpherical(this._spherical),En.applyQuaternion(this._quatInverse),e.copy(this.target).add(En),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=En.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new G(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new G(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=En.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(iu.origin.copy(this.object.position),iu.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(iu.direction))<QE?this.object.lookAt(this.target):(j0.setFromNormalAndCoplanarPoint(this.object.up,this.target),iu.intersectPlane(j0,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Td||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Td||this._lastTargetPosition.distanceToSquared(this.target)>Td?(this.dispatchEvent(K0),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?li/60*this.autoRotateSpeed*t:li/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){En.setFromMatrixColumn(e,0),En.multiplyScalar(-t),this._panOffset.add(En)}_panUp(t,e){this.screenSpacePanning===!0?En.setFromMatrixColumn(e,1):(En.setFromMatrixColumn(e,0),En.crossVectors(this.object.up,En)),En.multiplyScalar(t),this._panOffset.add(En)}_pan(t,e){let n=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;En.copy(s).sub(this.target);let r=En.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/n.clientHeight,this.object.matrix),this._panUp(2*e*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),s=t-n.left,r=e-n.top,o=n.width,a=n.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(li*this._rotateDelta.x/e.clientHeight),this._rotateUp(li*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(li*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-li*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(li*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-li*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(n,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(n*n+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let n=this._getSecondPointerPosition(t),s=.5*(t.pageX+n.x),r=.5*(t.pageY+n.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(li*this._rotateDelta.x/e.clientHeight),this._rotateUp(li*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new Jt,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,n={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function t1(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function e1(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function n1(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(Q0),this.state=Pe.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function i1(i){let t;switch(i.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case js.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=Pe.DOLLY;break;case js.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Pe.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Pe.ROTATE}break;case js.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Pe.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Pe.PAN}break;default:this.state=Pe.NONE}this.state!==Pe.NONE&&this.dispatchEvent(Ed)}function s1(i){switch(this.state){case Pe.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case Pe.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case Pe.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function r1(i){this.enabled===!1||this.enableZoom===!1||this.state!==Pe.NONE||(i.preventDefault(),this.dispatchEvent(Ed),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(Q0))}function o1(i){this.enabled!==!1&&this._handleKeyDown(i)}function a1(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case Qs.ROTATE:if(this.enableRotate===!1){this.state=Pe.NONE;break}this._handleTouchStartRotate(i),this.state=Pe.TOUCH_ROTATE;break;case Qs.PAN:if(this.enablePan===!1){this.state=Pe.NONE;break}this._handleTouchStartPan(i),this.state=Pe.TOUCH_PAN;break;default:this.state=Pe.NONE}break;case 2:switch(this.touches.TWO){case Qs.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=Pe.TOUCH_DOLLY_PAN;break;case Qs.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=Pe.TOUCH_DOLLY_ROTATE;break;default:this.state=Pe.NONE}break;default:this.state=Pe.NONE}this.state!==Pe.NONE&&this.dispatchEvent(Ed)}function l1(i){switch(this._trackPointer(i),this.state){case Pe.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case Pe.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case Pe.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case Pe.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=Pe.NONE}}function c1(i){this.enabled!==!1&&i.preventDefault()}function h1(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function u1(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var f1=80;function d1(i){let t=i.getContext(),e=t.getExtension("WEBGL_debug_renderer_info"),n=t.getParameter(e?e.UNMASKED_RENDERER_WEBGL:t.RENDERER);return/swiftshader|llvmpipe|software/i.test(n)}var Ad=class{#t;constructor(t,e){this.canvas=e,this.box=e.parentElement,this.renderer=t,this.pause=d1(t)?f1:0,this.#t=si(()=>this.draw()),this.moving=()=>!1,this.renderer.setPixelRatio(Math.min(devicePixelRatio,2)),this.scene=new ya,this.scene.background=new ue(923422),this.camera=new jn(36,1,10,8e3),this.camera.up.set(0,0,1),this.camera.position.set(1600,-1090,880),this.controls=new su(this.camera,e),this.controls.target.set(380,10,285),this.controls.maxDistance=4e3,this.controls.minDistance=200,this.controls.addEventListener("change",()=>this.ask()),this.controls.update(),this.light(),new ResizeObserver(()=>this.resize()).observe(this.box)}light(){let t=new Fa(16777215,2.2);t.position.set(900,-700,1600);let e=new Ba(2e3,20,3493983,1911863);e.rotation.x=Math.PI/2,this.scene.add(new Da(14674674,2569277,1.3),new Oa(16777215,.25),t,e)}resize(){let{clientWidth:t,clientHeight:e}=this.box;!t||!e||(this.renderer.setSize(t,e,!1),this.camera.aspect=t/e,this.camera.updateProjectionMatrix(),this.ask())}ask(){this.#t()}says(t,e){this.canvas.dataset[t]=String(e)}draw(){let t=this.moving();this.renderer.render(this.scene,this.camera),t&&(this.pause?setTimeout(()=>this.ask(),this.pause):this.ask())}};function t_(){let i=_t("scene"),t;try{t=new Xh({canvas:i,antialias:!0})}catch{return _t("scene-note").hidden=!1,_t("scene-note").textContent="This browser draws nothing in three dimensions (WebGL is off). All else works.",null}return new Ad(t,i)}var p1="NO_ACTION",m1=i=>i.replace(/\d+\.\d+/g,t=>String(Math.round(Number(t)*10)/10)),e_=i=>i.map(t=>dl(t,0)).join("  "),g1=i=>i.map(([,t],e)=>t.split(" ")[1]===i[e+1]?.[1].split(" ")[1]?t.split(" ")[0]:t).join("  "),_1={pose:([,,...i])=>[["grip",`${e_(i.slice(0,3))} mm`],["turned",`${e_(i.slice(3))} \xB0`]],joints:([,i,t],e)=>[["joints",g1(e.words($(i),t,0))]],gripper:([,,i])=>[["gripper",`${i.toFixed(0)} mm`]],arm:([,,i,t])=>[["arm",$(t)===p1?$(i):`${$(i)}  ${m1($(t)).slice(0,40)}`]]},ru=class{#t="robot";#e={};#n;#i;constructor(t,e,n){this.#n=e,this.#i=n,e.onChange(()=>this.#r());let s=(r,o)=>t.follow(o,a=>{this.#e[r]=a.map(ut),this.#r()});s("pose","(arm-pose ?robot ?x ?y ?z ?rx ?ry ?rz)"),s("joints","(arm-joints ?robot ?joints)"),s("gripper","(gripper ?robot ?opening)"),s("arm","(arm ?robot ?state ?action)")}show(t){this.#t=t,this.#r()}#s(t){return this.#e[t]?.find(e=>$(e[1])===this.#t)}#r(){let t=Object.entries(_1).flatMap(([e,n])=>{let s=this.#s(e);return s?n(s,this.#n):[]});_t("readings").replaceChildren(...t.flatMap(([e,n])=>[E("dt",{},e),E("dd",{},n)])),this.#i(this.#s("gripper")?.[2])}};var Cd=8;function x1(i){if(!i)return"not looked for";let{state:t,confidence:e,spread:n}=i;if(t!=="seen"&&t!=="found")return t;let s=e===void 0?t:`${(e*100).toFixed(0)} %`;return n&&n>0?`${s}  \xB1${(2*n).toFixed(1)} mm`:s}function n_(i){let t=_t("beliefs"),e=[],n=new Map,s=si(()=>{let r=e.slice(0,Cd).flatMap(a=>[E("dt",{},Xt(a,16)),E("dd",{},x1(n.get(a)))]),o=e.length>Cd?[E("dt",{},"and"),E("dd",{},`${e.length-Cd} more`)]:[];t.replaceChildren(...r,...o)});return i.follow("(place ?name ?x ?y ?z ?frame)",r=>{e=r.map(o=>$(ut(o)[1])).sort(),s()}),r=>{n=r,s()}}var y1=new Ei({color:16732120,depthTest:!1,transparent:!0}),ou=class{#t=new kn;#e=new Map;#n=60;#i=E("span",{id:"truth-note",class:"quiet"});#s=E("input",{type:"checkbox",id:"truth"});#r=E("label",{class:"over",id:"truth-choice",hidden:!0},this.#s," The world\u2019s truth ",this.#i);constructor(t,e){this.view=e,e.scene.add(this.#t),_t("scene-card").append(this.#r),this.#s.addEventListener("change",()=>{this.#a([]),this.#i.textContent="",t.layTruth(this.#s.checked?(n,s)=>this.#o(n,s):null)})}setCell({truth:t,cube:e}){this.#r.hidden=!t,this.#n=e}#o(t,e){if(!this.#s.checked)return;let n=(t??[]).filter(s=>$(s[0])==="cube"&&$(s[7])!=="gone");this.#i.textContent=t?`pink: ${n.length} objects, known to no agent`:e??"",this.#a(n)}#a(t){let e=new Set(t.map(n=>$(n[1])));for(let[n,s]of this.#e)e.has(n)||(this.#t.remove(s),this.#e.delete(n));for(let[,n,s,r,o,a]of t){let l=this.#e.get($(n))??this.#l($(n));l.position.set(s,r,o),l.rotation.z=a*Math.PI/180}this.view.says("truth",this.#e.size),this.view.ask()}#l(t){let e=new Ca(new _i(this.#n,this.#n,this.#n)),n=new rs(e,y1);return n.renderOrder=1,this.#e.set(t,n),this.#t.add(n),n}};function v1(i,t){let e=new nu(t),n=new jh(i,t),s=new Yh,r=new Map,o=new Qh(i,t,()=>n.believe(r,o.frame)),a=new ou(i,t);return t.scene.add(n.group,s.line),t.moving=()=>{let l=[e.step(),n.step()];return s.show(e.grip,n.topOfTarget()),l.includes(!0)},V0(i,l=>n.mark(l)),{arm:e,believe:l=>{r=l,n.believe(r,o.frame),t.ask()},setCell:l=>{for(let c of[n,e,o,a])c.setCell(l)}}}function i_(i,t,e){let n=t_(),s=n&&v1(i,n),r=new ru(i,e,h=>s?.arm.open(h)),o=n_(i);J0(i,h=>{s?.believe(h),o(h)});let a="",l="robot",c=()=>{a=t.server("robot")||l,r.show(a),s?.arm.choose(a)};return t.onChange(()=>(t.server("robot")||a)!==a&&c()),{moveArm:h=>s?.arm.move(h),setCell:h=>{l=h.arms[0]??"robot",s?.setCell(h),c()}}}var S1="uplot",M1="u-hz",b1="u-vt",w1="u-title",T1="u-wrap",E1="u-under",A1="u-over",C1="u-axis",Er="u-off",R1="u-select",P1="u-cursor-x",I1="u-cursor-y",L1="u-cursor-pt",D1="u-legend",N1="u-live",U1="u-inline",F1="u-series",O1="u-marker",s_="u-label",B1="u-value",Qa="width",tl="height";var r_="bottom",Po="left",Rd="right",qd="#000",o_=qd+"0",Pd="mousemove",a_="mousedown",Id="mouseup",l_="mouseenter",c_="mouseleave",h_="dblclick",k1="resize",z1="scroll",u_="change",uu="dppxchange",$d="--",Oo=typeof window<"u",Fd=Oo?document:null,Lo=Oo?window:null,V1=Oo?navigator:null,Ie,au;function Od(){let i=devicePixelRatio;Ie!=i&&(Ie=i,au&&kd(u_,au,Od),au=matchMedia(`(min-resolution: ${Ie-.001}dppx) and (max-resolution: ${Ie+.001}dppx)`),Ar(u_,au,Od),Lo.dispatchEvent(new CustomEvent(uu)))}function yi(i,t){if(t!=null){let e=i.classList;!e.contains(t)&&e.add(t)}}function Bd(i,t){let e=i.classList;e.contains(t)&&e.remove(t)}function Je(i,t,e){i.style[t]=e+"px"}function Gi(i,t,e,n){let s=Fd.createElement(i);return t!=null&&yi(s,t),e?.insertBefore(s,n),s}function Ai(i,t){return Gi("div",i,t)}var f_=new WeakMap;function us(i,t,e,n,s){let r="translate("+t+"px,"+e+"px)",o=f_.get(i);r!=o&&(i.style.transform=r,f_.set(i,r),t<0||e<0||t>n||e>s?yi(i,Er):Bd(i,Er))}var d_=new WeakMap;function p_(i,t,e){let n=t+e,s=d_.get(i);n!=s&&(d_.set(i,n),i.style.background=t,i.style.borderColor=e)}var m_=new WeakMap;function g_(i,t,e,n){let s=t+""+e,r=m_.get(i);s!=r&&(m_.set(i,s),i.style.height=e+"px",i.style.width=t+"px",i.style.marginLeft=n?-t/2+"px":0,i.style.marginTop=n?-e/2+"px":0)}var Yd={passive:!0},G1={...Yd,capture:!0};function Ar(i,t,e,n){t.addEventListener(i,e,n?G1:Yd)}function kd(i,t,e,n){t.removeEventListener(i,e,Yd)}Oo&&Od();function Hi(i,t,e,n){let s;e=e||0,n=n||t.length-1;let r=n<=2147483647;for(;n-e>1;)s=r?e+n>>1:vi((e+n)/2),t[s]<i?e=s:n=s;return i-t[e]<=t[n]-i?e:n}function W_(i){return(e,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(e[a])){r=a;break}for(let a=s;a>=n;a--)if(i(e[a])){o=a;break}return[r,o]}}var X_=i=>i!=null,q_=i=>i!=null&&i>0,pu=W_(X_),H1=W_(q_);function W1(i,t,e,n=0,s=!1){let r=s?H1:pu,o=s?q_:X_;[t,e]=r(i,t,e);let a=i[t],l=i[t];if(t>-1)if(n==1)a=i[t],l=i[e];else if(n==-1)a=i[e],l=i[t];else for(let c=t;c<=e;c++){let h=i[c];o(h)&&(h<a?a=h:h>l&&(l=h))}return[a??Ve,l??-Ve]}function mu(i,t,e,n){let s=y_(i),r=y_(t);i==t&&(s==-1?(i*=e,t/=e):(i/=e,t*=e));let o=e==10?Is:$_,a=s==1?vi:Ci,l=r==1?Ci:vi,c=a(o(Cn(i))),h=l(o(Cn(t))),u=Do(e,c),f=Do(e,h);return e==10&&(c<0&&(u=Ge(u,-c)),h<0&&(f=Ge(f,-h))),n||e==2?(i=u*s,t=f*r):(i=K_(i,u),t=gu(t,f)),[i,t]}function Zd(i,t,e,n){let s=mu(i,t,e,n);return i==0&&(s[0]=0),t==0&&(s[1]=0),s}var Jd=.1,__={mode:3,pad:Jd},nl={pad:0,soft:null,mode:0},X1={min:nl,max:nl};function fu(i,t,e,n){return _u(e)?x_(i,t,e):(nl.pad=e,nl.soft=n?0:null,nl.mode=n?3:0,x_(i,t,X1))}function Ae(i,t){return i??t}function q1(i,t,e){for(t=Ae(t,0),e=Ae(e,i.length-1);t<=e;){if(i[t]!=null)return!0;t++}return!1}function x_(i,t,e){let n=e.min,s=e.max,r=Ae(n.pad,0),o=Ae(s.pad,0),a=Ae(n.hard,-Ve),l=Ae(s.hard,Ve),c=Ae(n.soft,Ve),h=Ae(s.soft,-Ve),u=Ae(n.mode,0),f=Ae(s.mode,0),d=t-i,g=Is(d),y=ii(Cn(i),Cn(t)),p=Is(y),m=Cn(p-g);(d<1e-24||m>10)&&(d=0,(i==0||t==0)&&(d=1e-24,u==2&&c!=Ve&&(r=0),f==2&&h!=-Ve&&(o=0)));let v=d||y||1e3,C=Is(v),b=Do(10,vi(C)),P=v*(d==0?i==0?.1:1:r),A=Ge(K_(i-P,b/10),24),x=i>=c&&(u==1||u==3&&A<=c||u==2&&A>=c)?c:Ve,T=ii(a,A<x&&i>=x?x:Wi(x,A)),k=v*(d==0?t==0?.1:1:o),U=Ge(gu(t+k,b/10),24),N=t<=h&&(f==1||f==3&&U>=h||f==2&&U<=h)?h:-Ve,z=Wi(l,U>N&&t<=N?N:ii(N,U));return T==z&&T==0&&(z=100),[T,z]}var $1=new Intl.NumberFormat(Oo?V1.language:"en-US"),Kd=i=>$1.format(i),Si=Math,hu=Si.PI,Cn=Si.abs,vi=Si.floor,An=Si.round,Ci=Si.ceil,Wi=Si.min,ii=Si.max,Do=Si.pow,y_=Si.sign,Is=Si.log10,$_=Si.log2,Y1=(i,t=1)=>Si.sinh(i)*t,Ld=(i,t=1)=>Si.asinh(i/t),Ve=1/0;function v_(i){return(Is((i^i>>31)-(i>>31))|0)+1}function zd(i,t,e){return Wi(ii(i,t),e)}function Y_(i){return typeof i=="function"}function be(i){return Y_(i)?i:()=>i}var Z1=()=>{},Z_=i=>i,J_=(i,t)=>t,J1=i=>null,S_=i=>!0,M_=(i,t)=>i==t,K1=/\.\d*?(?=9{6,}|0{6,})/gm,Cr=i=>{if(Q_(i)||sr.has(i))return i;let t=`${i}`,e=t.match(K1);if(e==null)return i;let n=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${Cr(s)}e${r}`}return Ge(i,n)};function wr(i,t){return Cr(Ge(Cr(i/t))*t)}function gu(i,t){return Cr(Ci(Cr(i/t))*t)}function K_(i,t){return Cr(vi(Cr(i/t))*t)}function Ge(i,t=0){if(Q_(i))return i;let e=10**t,n=i*e*(1+Number.EPSILON);return An(n)/e}var sr=new Map;function j_(i){return((""+i).split(".")[1]||"").length}function sl(i,t,e,n){let s=[],r=n.map(j_);for(let o=t;o<e;o++){let a=Cn(o),l=Ge(Do(i,o),a);for(let c=0;c<n.length;c++){let h=i==10?+`${n[c]}e${o}`:n[c]*l,u=(o>=0?0:a)+(o>=r[c]?0:r[c]),f=i==10?h:Ge(h,u);s.push(f),sr.set(f,u)}}return s}var il={},jd=[],No=[null,null],ir=Array.isArray,Q_=Number.isInteger,j1=i=>i===void 0;function b_(i){return typeof i=="string"}function _u(i){let t=!1;if(i!=null){let e=i.constructor;t=e==null||e==Object}return t}function Q1(i){return i!=null&&typeof i=="object"}var tA=Object.getPrototypeOf(Uint8Array),tx="__proto__";function Uo(i,t=_u){let e;if(ir(i)){let n=i.find(s=>s!=null);if(ir(n)||t(n)){e=Array(i.length);for(let s=0;s<i.length;s++)e[s]=Uo(i[s],t)}else e=i.slice()}else if(i instanceof tA)e=i.slice();else if(t(i)){e={};for(let n in i)n!=tx&&(e[n]=Uo(i[n],t))}else e=i;return e}function xn(i){let t=arguments;for(let e=1;e<t.length;e++){let n=t[e];for(let s in n)s!=tx&&(_u(i[s])?xn(i[s],Uo(n[s])):i[s]=Uo(n[s]))}return i}var eA=0,nA=1,iA=2;function sA(i,t,e){for(let n=0,s,r=-1;n<t.length;n++){let o=t[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<e&&i[s]==null;)i[r=s++]=null}}}function rA(i,t){if(lA(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return cA(o[0])||(o=aA(o)),o}let e=new Set;for(let o=0;o<i.length;o++){let l=i[o][0],c=l.length;for(let h=0;h<c;h++)e.add(l[h])}let n=[Array.from(e).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],l=a[0];for(let c=1;c<a.length;c++){let h=a[c],u=Array(s).fill(void 0),f=t?t[o][c]:nA,d=[];for(let g=0;g<h.length;g++){let y=h[g],p=r.get(l[g]);y===null?f!=eA&&(u[p]=y,f==iA&&d.push(p)):u[p]=y}sA(u,d,s),n.push(u)}}return n}var oA=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function aA(i){let t=i[0],e=t.length,n=Array(e);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[n[l]];s.push(a)}return s}function lA(i){let t=i[0][0],e=t.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function cA(i,t=100){let e=i.length;if(e<=1)return!0;let n=0,s=e-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=ii(1,vi((s-n+1)/t));for(let o=i[n],a=n+r;a<=s;a+=r){let l=i[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var ex=["January","February","March","April","May","June","July","August","September","October","November","December"],nx=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function ix(i){return i.slice(0,3)}var hA=nx.map(ix),uA=ex.map(ix),fA={MMMM:ex,MMM:uA,WWWW:nx,WWW:hA};function ja(i){return(i<10?"0":"")+i}function dA(i){return(i<10?"00":i<100?"0":"")+i}var pA={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,t)=>t.MMMM[i.getMonth()],MMM:(i,t)=>t.MMM[i.getMonth()],MM:i=>ja(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>ja(i.getDate()),D:i=>i.getDate(),WWWW:(i,t)=>t.WWWW[i.getDay()],WWW:(i,t)=>t.WWW[i.getDay()],HH:i=>ja(i.getHours()),H:i=>i.getHours(),h:i=>{let t=i.getHours();return t==0?12:t>12?t-12:t},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>ja(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>ja(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>dA(i.getMilliseconds())};function Qd(i,t){t=t||fA;let e=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)e.push(s[0][0]=="{"?pA[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var mA=new Intl.DateTimeFormat().resolvedOptions().timeZone;function gA(i,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+i+i.getTimezoneOffset()*6e4):t==mA?e=i:(e=new Date(i.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(i.getMilliseconds())),e}var sx=i=>i%1==0,du=[1,2,2.5,5],_A=sl(10,-32,0,du),rx=sl(10,0,32,du),xA=rx.filter(sx),Tr=_A.concat(rx),tp=`
`,ox="{YYYY}",w_=tp+ox,ax="{M}/{D}",el=tp+ax,lu=el+"/{YY}",lx="{aa}",yA="{h}:{mm}",Io=yA+lx,T_=tp+Io,E_=":{ss}",Ne=null;function cx(i){let t=i*1e3,e=t*60,n=e*60,s=n*24,r=s*30,o=s*365,l=(i==1?sl(10,0,3,du).filter(sx):sl(10,-3,0,du)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,ox,Ne,Ne,Ne,Ne,Ne,Ne,1],[s*28,"{MMM}",w_,Ne,Ne,Ne,Ne,Ne,1],[s,ax,w_,Ne,Ne,Ne,Ne,Ne,1],[n,"{h}"+lx,lu,Ne,el,Ne,Ne,Ne,1],[e,Io,lu,Ne,el,Ne,Ne,Ne,1],[t,E_,lu+" "+Io,Ne,el+" "+Io,Ne,T_,Ne,1],[i,E_+".{fff}",lu+" "+Io,Ne,el+" "+Io,Ne,T_,Ne,1]];function h(u){return(f,d,g,y,p,m)=>{let v=[],C=p>=o,b=p>=r&&p<o,P=u(g),A=Ge(P*i,3),x=Dd(P.getFullYear(),C?0:P.getMonth(),b||C?1:P.getDate()),T=Ge(x*i,3);if(b||C){let k=b?p/r:0,U=C?p/o:0,N=A==T?A:Ge(Dd(x.getFullYear()+U,x.getMonth()+k,1)*i,3),z=new Date(An(N/i)),W=z.getFullYear(),D=z.getMonth();for(let X=0;N<=y;X++){let Z=Dd(W+U*X,D+k*X,1),H=Z-u(Ge(Z*i,3));N=Ge((+Z+H)*i,3),N<=y&&v.push(N)}}else{let k=p>=s?s:p,U=vi(g)-vi(A),N=T+U+gu(A-T,k);v.push(N);let z=u(N),W=z.getHours()+z.getMinutes()/e+z.getSeconds()/n,D=p/n,X=f.axes[d]._space,Z=m/X;for(;N=Ge(N+p,i==1?0:3),!(N>y);)if(D>1){let H=vi(Ge(W+D,6))%24,tt=u(N).getHours()-H;tt>1&&(tt=-1),N-=tt*n,W=(W+D)%24;let rt=v[v.length-1];Ge((N-rt)/p,3)*Z>=.7&&v.push(N)}else v.push(N)}return v}}return[l,c,h]}var[vA,SA,MA]=cx(1),[bA,wA,TA]=cx(.001);sl(2,-53,53,[1]);function A_(i,t){return i.map(e=>e.map((n,s)=>s==0||s==8||n==null?n:t(s==1||e[8]==0?n:e[1]+n)))}function C_(i,t){return(e,n,s,r,o)=>{let a=t.find(g=>o>=g[0])||t[t.length-1],l,c,h,u,f,d;return n.map(g=>{let y=i(g),p=y.getFullYear(),m=y.getMonth(),v=y.getDate(),C=y.getHours(),b=y.getMinutes(),P=y.getSeconds(),A=p!=l&&a[2]||m!=c&&a[3]||v!=h&&a[4]||C!=u&&a[5]||b!=f&&a[6]||P!=d&&a[7]||a[1];return l=p,c=m,h=v,u=C,f=b,d=P,A(y)})}}function EA(i,t){let e=Qd(t);return(n,s,r,o,a)=>s.map(l=>e(i(l)))}function Dd(i,t,e){return new Date(i,t,e)}function R_(i,t){return t(i)}var AA="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function P_(i,t){return(e,n,s,r)=>r==null?$d:t(i(n))}function CA(i,t){let e=i.series[t];return e.width?e.stroke(i,t):e.points.width?e.points.stroke(i,t):null}function RA(i,t){return i.series[t].fill(i,t)}var PA={show:!0,live:!0,isolate:!1,mount:Z1,markers:{show:!0,width:2,stroke:CA,fill:RA,dash:"solid"},idx:null,idxs:null,values:[]};function IA(i,t){let e=i.cursor.points,n=Ai(),s=e.size(i,t);Je(n,Qa,s),Je(n,tl,s);let r=s/-2;Je(n,"marginLeft",r),Je(n,"marginTop",r);let o=e.width(i,t,s);return o&&Je(n,"borderWidth",o),n}function LA(i,t){let e=i.series[t].points;return e._fill||e._stroke}function DA(i,t){let e=i.series[t].points;return e._stroke||e._fill}function NA(i,t){return i.series[t].points.size}var Nd=[0,0];function UA(i,t,e){return Nd[0]=t,Nd[1]=e,Nd}function cu(i,t,e,n=!0){return s=>{s.button==0&&(!n||s.target==t)&&e(s)}}function Ud(i,t,e,n=!0){return s=>{(!n||s.target==t)&&e(s)}}var FA={show:!0,x:!0,y:!0,lock:!1,move:UA,points:{one:!1,show:IA,size:NA,width:0,stroke:DA,fill:LA},bind:{mousedown:cu,mouseup:cu,click:cu,dblclick:cu,mousemove:Ud,mouseleave:Ud,mouseenter:Ud},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,t,e,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},hx={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},ep=xn({},hx,{filter:J_}),ux=xn({},ep,{size:10}),fx=xn({},hx,{show:!1}),np='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',dx="bold "+np,px=1.5,I_={show:!0,scale:"x",stroke:qd,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:dx,side:2,grid:ep,ticks:ux,border:fx,font:np,lineGap:px,rotate:0},OA="Value",BA="Time",L_={show:!0,scale:"x",auto:!1,sorted:1,min:Ve,max:-Ve,idxs:[]};function kA(i,t,e,n,s){return t.map(r=>r==null?"":Kd(r))}function zA(i,t,e,n,s,r,o){let a=[],l=sr.get(s)||0;e=o?e:Ge(gu(e,s),l);for(let c=e;c<=n;c=Ge(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Vd(i,t,e,n,s,r,o){let a=[],l=i.scales[i.axes[t].scale].log,c=l==10?Is:$_,h=vi(c(e));s=Do(l,h),l==10&&(s=Tr[Hi(s,Tr)]);let u=e,f=s*l;l==10&&(f=Tr[Hi(f,Tr)]);do a.push(u),u=u+s,l==10&&!sr.has(u)&&(u=Ge(u,sr.get(s))),u>=f&&(s=u,f=s*l,l==10&&(f=Tr[Hi(f,Tr)]));while(u<=n);return a}function VA(i,t,e,n,s,r,o){let l=i.scales[i.axes[t].scale].asinh,c=n>l?Vd(i,t,ii(l,e),n,s):[l],h=n>=0&&e<=0?[0]:[];return(e<-l?Vd(i,t,ii(l,-n),-e,s):[l]).reverse().map(f=>-f).concat(h,c)}var mx=/./,GA=/[12357]/,HA=/[125]/,D_=/1/,Gd=(i,t,e,n)=>i.map((s,r)=>t==4&&s==0||r%n==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function WA(i,t,e,n,s){let r=i.axes[e],o=r.scale,a=i.scales[o],l=i.valToPos,c=r._space,h=l(10,o),u=l(9,o)-h>=c?mx:l(7,o)-h>=c?GA:l(5,o)-h>=c?HA:D_;if(u==D_){let f=Cn(l(1,o)-h);if(f<c)return Gd(t.slice().reverse(),a.distr,u,Ci(c/f)).reverse()}return Gd(t,a.distr,u,1)}function XA(i,t,e,n,s){let r=i.axes[e],o=r.scale,a=r._space,l=i.valToPos,c=Cn(l(1,o)-l(2,o));return c<a?Gd(t.slice().reverse(),3,mx,Ci(a/c)).reverse():t}function qA(i,t,e,n){return n==null?$d:t==null?"":Kd(t)}var N_={show:!0,scale:"y",stroke:qd,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:dx,side:3,grid:ep,ticks:ux,border:fx,font:np,lineGap:px,rotate:0};function $A(i,t){let e=3+(i||1)*2;return Ge(e*t,3)}function YA(i,t){let{scale:e,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],e,!0),o=i.valToPos(s[n[1]],e,!0),a=Cn(o-r),l=i.series[t],c=a/(l.points.space*Ie);return n[1]-n[0]<=c}var U_={scale:null,auto:!0,sorted:0,min:Ve,max:-Ve},gx=(i,t,e,n,s)=>s,F_={show:!0,auto:!0,sorted:0,gaps:gx,alpha:1,facets:[xn({},U_,{scale:"x"}),xn({},U_,{scale:"y"})]},O_={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:gx,alpha:1,points:{show:YA,filter:null},values:null,min:Ve,max:-Ve,idxs:[],path:null,clip:null};function ZA(i,t,e,n,s){return e/10}var _x={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},JA=xn({},_x,{time:!1,ori:1}),B_={};function xx(i,t){let e=B_[i];return e||(e={key:i,plots:[],sub(n){e.plots.push(n)},unsub(n){e.plots=e.plots.filter(s=>s!=n)},pub(n,s,r,o,a,l,c){for(let h=0;h<e.plots.length;h++)e.plots[h]!=s&&e.plots[h].pub(n,s,r,o,a,l,c)}},i!=null&&(B_[i]=e)),e}var Fo=1,Hd=2;function Rr(i,t,e){let n=i.mode,s=i.series[t],r=n==2?i._data[t]:i._data,o=i.scales,a=i.bbox,l=r[0],c=n==2?r[1]:r[t],h=n==2?o[s.facets[0].scale]:o[i.series[0].scale],u=n==2?o[s.facets[1].scale]:o[s.scale],f=a.left,d=a.top,g=a.width,y=a.height,p=i.valToPosH,m=i.valToPosV;return h.ori==0?e(s,l,c,h,u,p,m,f,d,g,y,yu,Bo,Su,vx,Mx):e(s,l,c,h,u,m,p,d,f,y,g,vu,ko,rp,Sx,bx)}function ip(i,t){let e=0,n=0,s=Ae(i.bands,jd);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?n|=1:n|=2)}return[e,n==1?-1:n==2?1:n==3?2:0]}function KA(i,t,e,n,s){let r=i.mode,o=i.series[t],a=r==2?o.facets[1].scale:o.scale,l=i.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Ls(i,t,e,n,s,r){return Rr(i,t,(o,a,l,c,h,u,f,d,g,y,p)=>{let m=o.pxRound,v=c.dir*(c.ori==0?1:-1),C=c.ori==0?Bo:ko,b,P;v==1?(b=e,P=n):(b=n,P=e);let A=m(u(a[b],c,y,d)),x=m(f(l[b],h,p,g)),T=m(u(a[P],c,y,d)),k=m(f(r==1?h.max:h.min,h,p,g)),U=new Path2D(s);return C(U,T,k),C(U,A,k),C(U,A,x),U})}function xu(i,t,e,n,s,r){let o=null;if(i.length>0){o=new Path2D;let a=t==0?Su:rp,l=e;for(let u=0;u<i.length;u++){let f=i[u];if(f[1]>f[0]){let d=f[0]-l;d>0&&a(o,l,n,d,n+r),l=f[1]}}let c=e+s-l,h=10;c>0&&a(o,l,n-h/2,c,n+r+h)}return o}function jA(i,t,e){let n=i[i.length-1];n&&n[0]==t?n[1]=e:i.push([t,e])}function sp(i,t,e,n,s,r,o){let a=[],l=i.length;for(let c=s==1?e:n;c>=e&&c<=n;c+=s)if(t[c]===null){let u=c,f=c;if(s==1)for(;++c<=n&&t[c]===null;)f=c;else for(;--c>=e&&t[c]===null;)f=c;let d=r(i[u]),g=f==u?d:r(i[f]),y=u-s;d=o<=0&&y>=0&&y<l?r(i[y]):d;let m=f+s;g=o>=0&&m>=0&&m<l?r(i[m]):g,g>=d&&a.push([d,g])}return a}function k_(i){return i==0?Z_:i==1?An:t=>wr(t,i)}function yx(i){let t=i==0?yu:vu,e=i==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},n=i==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,h=0)=>{c==0&&h==0?n(s,r,o,a,l):(c=Wi(c,a/2,l/2),h=Wi(h,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,h),e(s,r,o+l,r,o,h),e(s,r,o,r+a,o,c),s.closePath())}}var yu=(i,t,e)=>{i.moveTo(t,e)},vu=(i,t,e)=>{i.moveTo(e,t)},Bo=(i,t,e)=>{i.lineTo(t,e)},ko=(i,t,e)=>{i.lineTo(e,t)},Su=yx(0),rp=yx(1),vx=(i,t,e,n,s,r)=>{i.arc(t,e,n,s,r)},Sx=(i,t,e,n,s,r)=>{i.arc(e,t,n,s,r)},Mx=(i,t,e,n,s,r,o)=>{i.bezierCurveTo(t,e,n,s,r,o)},bx=(i,t,e,n,s,r,o)=>{i.bezierCurveTo(e,t,s,n,o,r)};function wx(i){return(t,e,n,s,r)=>Rr(t,e,(o,a,l,c,h,u,f,d,g,y,p)=>{let{pxRound:m,points:v}=o,C,b;c.ori==0?(C=yu,b=vx):(C=vu,b=Sx);let P=Ge(v.width*Ie,3),A=(v.size-v.width)/2*Ie,x=Ge(A*2,3),T=new Path2D,k=new Path2D,{left:U,top:N,width:z,height:W}=t.bbox;Su(k,U-x,N-x,z+x*2,W+x*2);let D=X=>{if(l[X]!=null){let Z=m(u(a[X],c,y,d)),H=m(f(l[X],h,p,g));C(T,Z+A,H),b(T,Z,H,A,0,hu*2)}};if(r)r.forEach(D);else for(let X=n;X<=s;X++)D(X);return{stroke:P>0?T:null,fill:T,clip:k,flags:Fo|Hd}})}function Tx(i){return(t,e,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(t,e,n),r!=s&&o!=s&&i(t,e,s),i(t,e,o))}}var QA=Tx(Bo),tC=Tx(ko);function Ex(i){let t=Ae(i?.alignGaps,0);return(e,n,s,r)=>Rr(e,n,(o,a,l,c,h,u,f,d,g,y,p)=>{[s,r]=pu(l,s,r);let m=o.pxRound,v=W=>m(u(W,c,y,d)),C=W=>m(f(W,h,p,g)),b,P;c.ori==0?(b=Bo,P=QA):(b=ko,P=tC);let A=c.dir*(c.ori==0?1:-1),x={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Fo},T=x.stroke,k=!1;if(r-s>=y*4){let W=dt=>e.posToVal(dt,c.key,!0),D=null,X=null,Z,H,ht,j=v(a[A==1?s:r]),tt=v(a[s]),rt=v(a[r]),pt=W(A==1?tt+1:rt-1);for(let dt=A==1?s:r;dt>=s&&dt<=r;dt+=A){let et=a[dt],St=(A==1?et<pt:et>pt)?j:v(et),Pt=l[dt];St==j?Pt!=null?(H=Pt,D==null?(b(T,St,C(H)),Z=D=X=H):H<D?D=H:H>X&&(X=H)):Pt===null&&(k=!0):(D!=null&&P(T,j,C(D),C(X),C(Z),C(H)),Pt!=null?(H=Pt,b(T,St,C(H)),D=X=Z=H):(D=X=null,Pt===null&&(k=!0)),j=St,pt=W(j+A))}D!=null&&D!=X&&ht!=j&&P(T,j,C(D),C(X),C(Z),C(H))}else for(let W=A==1?s:r;W>=s&&W<=r;W+=A){let D=l[W];D===null?k=!0:D!=null&&b(T,v(a[W]),C(D))}let[N,z]=ip(e,n);if(o.fill!=null||N!=0){let W=x.fill=new Path2D(T),D=o.fillTo(e,n,o.min,o.max,N),X=C(D),Z=v(a[s]),H=v(a[r]);A==-1&&([H,Z]=[Z,H]),b(W,H,X),b(W,Z,X)}if(!o.spanGaps){let W=[];k&&W.push(...sp(a,l,s,r,A,v,t)),x.gaps=W=o.gaps(e,n,s,r,W),x.clip=xu(W,c.ori,d,g,y,p)}return z!=0&&(x.band=z==2?[Ls(e,n,s,r,T,-1),Ls(e,n,s,r,T,1)]:Ls(e,n,s,r,T,z)),x})}function eC(i){let t=Ae(i.align,1),e=Ae(i.ascDesc,!1),n=Ae(i.alignGaps,0),s=Ae(i.extend,!1);return(r,o,a,l)=>Rr(r,o,(c,h,u,f,d,g,y,p,m,v,C)=>{[a,l]=pu(u,a,l);let b=c.pxRound,{left:P,width:A}=r.bbox,x=tt=>b(g(tt,f,v,p)),T=tt=>b(y(tt,d,C,m)),k=f.ori==0?Bo:ko,U={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Fo},N=U.stroke,z=f.dir*(f.ori==0?1:-1),W=T(u[z==1?a:l]),D=x(h[z==1?a:l]),X=D,Z=D;s&&t==-1&&(Z=P,k(N,Z,W)),k(N,D,W);for(let tt=z==1?a:l;tt>=a&&tt<=l;tt+=z){let rt=u[tt];if(rt==null)continue;let pt=x(h[tt]),dt=T(rt);t==1?k(N,pt,W):k(N,X,dt),k(N,pt,dt),W=dt,X=pt}let H=X;s&&t==1&&(H=P+A,k(N,H,W));let[ht,j]=ip(r,o);if(c.fill!=null||ht!=0){let tt=U.fill=new Path2D(N),rt=c.fillTo(r,o,c.min,c.max,ht),pt=T(rt);k(tt,H,pt),k(tt,Z,pt)}if(!c.spanGaps){let tt=[];tt.push(...sp(h,u,a,l,z,x,n));let rt=c.width*Ie/2,pt=e||t==1?rt:-rt,dt=e||t==-1?-rt:rt;tt.forEach(et=>{et[0]+=pt,et[1]+=dt}),U.gaps=tt=c.gaps(r,o,a,l,tt),U.clip=xu(tt,f.ori,p,m,v,C)}return j!=0&&(U.band=j==2?[Ls(r,o,a,l,N,-1),Ls(r,o,a,l,N,1)]:Ls(r,o,a,l,N,j)),U})}function z_(i,t,e,n,s,r,o=Ve){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(t[l]!==void 0){if(a!=null){let h=Cn(i[l]-i[a]);h<c&&(c=h,o=Cn(e(i[l],n,s,r)-e(i[a],n,s,r)))}a=l}}return o}function nC(i){i=i||il;let t=Ae(i.size,[.6,Ve,1]),e=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=be(s),o=1-t[0],a=Ae(t[1],Ve),l=Ae(t[2],1),c=Ae(i.disp,il),h=Ae(i.each,d=>{}),{fill:u,stroke:f}=c;return(d,g,y,p)=>Rr(d,g,(m,v,C,b,P,A,x,T,k,U,N)=>{let z=m.pxRound,W=e,D=n*Ie,X=a*Ie,Z=l*Ie,H,ht;b.ori==0?[H,ht]=r(d,g):[ht,H]=r(d,g);let j=b.dir*(b.ori==0?1:-1),tt=b.ori==0?Su:rp,rt=b.ori==0?h:(Lt,Qt,he,Et,ze,Wt,Kt)=>{h(Lt,Qt,he,ze,Et,Kt,Wt)},pt=Ae(d.bands,jd).find(Lt=>Lt.series[0]==g),dt=pt!=null?pt.dir:0,et=m.fillTo(d,g,m.min,m.max,dt),xt=z(x(et,P,N,k)),St,Pt,Tt,Yt=U,ce=z(m.width*Ie),qt=!1,ge=null,de=null,ae=null,Ke=null;u!=null&&(ce==0||f!=null)&&(qt=!0,ge=u.values(d,g,y,p),de=new Map,new Set(ge).forEach(Lt=>{Lt!=null&&de.set(Lt,new Path2D)}),ce>0&&(ae=f.values(d,g,y,p),Ke=new Map,new Set(ae).forEach(Lt=>{Lt!=null&&Ke.set(Lt,new Path2D)})));let{x0:He,size:un}=c;if(He!=null&&un!=null){W=1,v=He.values(d,g,y,p),He.unit==2&&(v=v.map(he=>d.posToVal(T+he*U,b.key,!0)));let Lt=un.values(d,g,y,p);un.unit==2?Pt=Lt[0]*U:Pt=A(Lt[0],b,U,T)-A(0,b,U,T),Yt=z_(v,C,A,b,U,T,Yt),Tt=Yt-Pt+D}else Yt=z_(v,C,A,b,U,T,Yt),Tt=Yt*o+D,Pt=Yt-Tt;Tt<1&&(Tt=0),ce>=Pt/2&&(ce=0),Tt<5&&(z=Z_);let Be=Tt>0,Rn=Yt-Tt-(Be?ce:0);Pt=z(zd(Rn,Z,X)),St=(W==0?Pt/2:W==j?0:Pt)-W*j*((W==0?D/2:0)+(Be?ce/2:0));let we={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},yn=qt?null:new Path2D,en=null;if(pt!=null)en=d.data[pt.series[1]];else{let{y0:Lt,y1:Qt}=c;Lt!=null&&Qt!=null&&(C=Qt.values(d,g,y,p),en=Lt.values(d,g,y,p))}let fn=H*Pt,O=ht*Pt;for(let Lt=j==1?y:p;Lt>=y&&Lt<=p;Lt+=j){let Qt=C[Lt];if(Qt==null)continue;if(en!=null){let q=en[Lt]??0;if(Qt-q==0)continue;xt=x(q,P,N,k)}let he=b.distr!=2||c!=null?v[Lt]:Lt,Et=A(he,b,U,T),ze=x(Ae(Qt,et),P,N,k),Wt=z(Et-St),Kt=z(ii(ze,xt)),R=z(Wi(ze,xt)),S=Kt-R;if(Qt!=null){let q=Qt<0?O:fn,ft=Qt<0?fn:O;qt?(ce>0&&ae[Lt]!=null&&tt(Ke.get(ae[Lt]),Wt,R+vi(ce/2),Pt,ii(0,S-ce),q,ft),ge[Lt]!=null&&tt(de.get(ge[Lt]),Wt,R+vi(ce/2),Pt,ii(0,S-ce),q,ft)):tt(yn,Wt,R+vi(ce/2),Pt,ii(0,S-ce),q,ft),rt(d,g,Lt,Wt-ce/2,R,Pt+ce,S)}}return ce>0?we.stroke=qt?Ke:yn:qt||(we._fill=m.width==0?m._fill:m._stroke??m._fill,we.width=0),we.fill=qt?de:yn,we})}function iC(i,t){let e=Ae(t?.alignGaps,0);return(n,s,r,o)=>Rr(n,s,(a,l,c,h,u,f,d,g,y,p,m)=>{[r,o]=pu(c,r,o);let v=a.pxRound,C=H=>v(f(H,h,p,g)),b=H=>v(d(H,u,m,y)),P,A,x;h.ori==0?(P=yu,x=Bo,A=Mx):(P=vu,x=ko,A=bx);let T=h.dir*(h.ori==0?1:-1),k=C(l[T==1?r:o]),U=k,N=[],z=[];for(let H=T==1?r:o;H>=r&&H<=o;H+=T)if(c[H]!=null){let j=l[H],tt=C(j);N.push(U=tt),z.push(b(c[H]))}let W={stroke:i(N,z,P,x,A,v),fill:null,clip:null,band:null,gaps:null,flags:Fo},D=W.stroke,[X,Z]=ip(n,s);if(a.fill!=null||X!=0){let H=W.fill=new Path2D(D),ht=a.fillTo(n,s,a.min,a.max,X),j=b(ht);x(H,U,j),x(H,k,j)}if(!a.spanGaps){let H=[];H.push(...sp(l,c,r,o,T,C,e)),W.gaps=H=a.gaps(n,s,r,o,H),W.clip=xu(H,h.ori,g,y,p,m)}return Z!=0&&(W.band=Z==2?[Ls(n,s,r,o,D,-1),Ls(n,s,r,o,D,1)]:Ls(n,s,r,o,D,Z)),W})}function sC(i){return iC(rC,i)}function rC(i,t,e,n,s,r){let o=i.length;if(o<2)return null;let a=new Path2D;if(e(a,i[0],t[0]),o==2)n(a,i[1],t[1]);else{let l=Array(o),c=Array(o-1),h=Array(o-1),u=Array(o-1);for(let f=0;f<o-1;f++)h[f]=t[f+1]-t[f],u[f]=i[f+1]-i[f],c[f]=h[f]/u[f];l[0]=c[0];for(let f=1;f<o-1;f++)c[f]===0||c[f-1]===0||c[f-1]>0!=c[f]>0?l[f]=0:(l[f]=3*(u[f-1]+u[f])/((2*u[f]+u[f-1])/c[f-1]+(u[f]+2*u[f-1])/c[f]),isFinite(l[f])||(l[f]=0));l[o-1]=c[o-2];for(let f=0;f<o-1;f++)s(a,i[f]+u[f]/3,t[f]+l[f]*u[f]/3,i[f+1]-u[f]/3,t[f+1]-l[f+1]*u[f]/3,i[f+1],t[f+1])}return a}var Wd=new Set;function V_(){for(let i of Wd)i.syncRect(!0)}Oo&&(Ar(k1,Lo,V_),Ar(z1,Lo,V_,!0),Ar(uu,Lo,()=>{zn.pxRatio=Ie}));var oC=Ex(),aC=wx();function G_(i,t,e,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>Xd(r,o,t,e))}function lC(i,t){return i.map((e,n)=>n==0?{}:xn({},t,e))}function Xd(i,t,e,n){return xn({},t==0?e:n,i)}function Ax(i,t,e){return t==null?No:[t,e]}var cC=Ax;function hC(i,t,e){return t==null?No:fu(t,e,Jd,!0)}function Cx(i,t,e,n){return t==null?No:mu(t,e,i.scales[n].log,!1)}var uC=Cx;function Rx(i,t,e,n){return t==null?No:Zd(t,e,i.scales[n].log,!1)}var fC=Rx;function dC(i,t,e,n,s){let r=ii(v_(i),v_(t)),o=t-i,a=Hi(s/n*o,e);do{let l=e[a],c=n*l/o;if(c>=s&&r+(l<5?sr.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function H_(i){let t,e;return i=i.replace(/(\d+)px/,(n,s)=>(t=An((e=+s)*Ie))+"px"),[i,t,e]}function pC(i){i.show&&[i.font,i.labelFont].forEach(t=>{let e=Ge(t[2]*Ie,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function zn(i,t,e){let n={mode:Ae(i.mode,1)},s=n.mode;function r(_,M,I,L){let V=M.valToPct(_);return L+I*(M.dir==-1?1-V:V)}function o(_,M,I,L){let V=M.valToPct(_);return L+I*(M.dir==-1?V:1-V)}function a(_,M,I,L){return M.ori==0?r(_,M,I,L):o(_,M,I,L)}n.valToPosH=r,n.valToPosV=o;let l=!1;n.status=0;let c=n.root=Ai(S1);if(i.id!=null&&(c.id=i.id),yi(c,i.class),i.title){let _=Ai(w1,c);_.textContent=i.title}let h=Gi("canvas"),u=n.ctx=h.getContext("2d"),f=Ai(T1,c);Ar("click",f,_=>{_.target===g&&(qe!=Or||je!=Br)&&On.click(n,_)},!0);let d=n.under=Ai(E1,f);f.appendChild(h);let g=n.over=Ai(A1,f);i=Uo(i);let y=+Ae(i.pxAlign,1),p=k_(y);(i.plugins||[]).forEach(_=>{_.opts&&(i=_.opts(n,i)||i)});let m=i.ms||.001,v=n.series=s==1?G_(i.series||[],L_,O_,!1):lC(i.series||[null],F_),C=n.axes=G_(i.axes||[],I_,N_,!0),b=n.scales={},P=n.bands=i.bands||[];P.forEach(_=>{_.fill=be(_.fill||null),_.dir=Ae(_.dir,-1)});let A=s==2?v[1].facets[0].scale:v[0].scale,x={axes:ms,series:xe},T=(i.drawOrder||["axes","series"]).map(_=>x[_]);function k(_){let M=_.distr==3?I=>Is(I>0?I:_.clamp(n,I,_.min,_.max,_.key)):_.distr==4?I=>Ld(I,_.asinh):_.distr==100?I=>_.fwd(I):I=>I;return I=>{let L=M(I),{_min:V,_max:K}=_,lt=K-V;return(L-V)/lt}}function U(_){let M=b[_];if(M==null){let I=(i.scales||il)[_]||il;if(I.from!=null){U(I.from);let L=xn({},b[I.from],I,{key:_});L.valToPct=k(L),b[_]=L}else{M=b[_]=xn({},_==A?_x:JA,I),M.key=_;let L=M.time,V=M.range,K=ir(V);if((_!=A||s==2&&!L)&&(K&&(V[0]==null||V[1]==null)&&(V={min:V[0]==null?__:{mode:1,hard:V[0],soft:V[0]},max:V[1]==null?__:{mode:1,hard:V[1],soft:V[1]}},K=!1),!K&&_u(V))){let lt=V;V=(mt,bt,Ft)=>bt==null?No:fu(bt,Ft,lt)}M.range=be(V||(L?cC:_==A?M.distr==3?uC:M.distr==4?fC:Ax:M.distr==3?Cx:M.distr==4?Rx:hC)),M.auto=be(K?!1:M.auto),M.clamp=be(M.clamp||ZA),M._min=M._max=null,M.valToPct=k(M)}}}U("x"),U("y"),s==1&&v.forEach(_=>{U(_.scale)}),C.forEach(_=>{U(_.scale)});for(let _ in i.scales)U(_);let N=b[A],z=N.distr,W,D;N.ori==0?(yi(c,M1),W=r,D=o):(yi(c,b1),W=o,D=r);let X={};for(let _ in b){let M=b[_];(M.min!=null||M.max!=null)&&(X[_]={min:M.min,max:M.max},M.min=M.max=null)}let Z=i.tzDate||(_=>new Date(An(_/m))),H=i.fmtDate||Qd,ht=m==1?MA(Z):TA(Z),j=C_(Z,A_(m==1?SA:wA,H)),tt=P_(Z,R_(AA,H)),rt=[],pt=n.legend=xn({},PA,i.legend),dt=n.cursor=xn({},FA,{drag:{y:s==2}},i.cursor),et=pt.show,xt=dt.show,St=pt.markers;pt.idxs=rt,St.width=be(St.width),St.dash=be(St.dash),St.stroke=be(St.stroke),St.fill=be(St.fill);let Pt,Tt,Yt,ce=[],qt=[],ge,de=!1,ae={};if(pt.live){let _=v[1]?v[1].values:null;de=_!=null,ge=de?_(n,1,0):{_:0};for(let M in ge)ae[M]=$d}if(et)if(Pt=Gi("table",D1,c),Yt=Gi("tbody",null,Pt),pt.mount(n,Pt),de){Tt=Gi("thead",null,Pt,Yt);let _=Gi("tr",null,Tt);Gi("th",null,_);for(var Ke in ge)Gi("th",s_,_).textContent=Ke}else yi(Pt,U1),pt.live&&yi(Pt,N1);let He={show:!0},un={show:!1};function Be(_,M){if(M==0&&(de||!pt.live||s==2))return No;let I=[],L=Gi("tr",F1,Yt,Yt.childNodes[M]);yi(L,_.class),_.show||yi(L,Er);let V=Gi("th",null,L);if(St.show){let mt=Ai(O1,V);if(M>0){let bt=St.width(n,M);bt&&(mt.style.border=bt+"px "+St.dash(n,M)+" "+St.stroke(n,M)),mt.style.background=St.fill(n,M)}}let K=Ai(s_,V);_.label instanceof HTMLElement?K.appendChild(_.label):K.textContent=_.label,M>0&&(St.show||(K.style.color=_.width>0?St.stroke(n,M):St.fill(n,M)),we("click",V,mt=>{if(dt._lock)return;ne(mt);let bt=v.indexOf(_);if((mt.ctrlKey||mt.metaKey)!=pt.isolate){let Ft=v.some((Ot,kt)=>kt>0&&kt!=bt&&Ot.show);v.forEach((Ot,kt)=>{kt>0&&Zi(kt,Ft?kt==bt?He:un:He,!0,gn.setSeries)})}else Zi(bt,{show:!_.show},!0,gn.setSeries)},!1),ie&&we(l_,V,mt=>{dt._lock||(ne(mt),Zi(v.indexOf(_),zr,!0,gn.setSeries))},!1));for(var lt in ge){let mt=Gi("td",B1,L);mt.textContent="--",I.push(mt)}return[L,I]}let Rn=new Map;function we(_,M,I,L=!0){let V=Rn.get(M)||{},K=dt.bind[_](n,M,I,L);K&&(Ar(_,M,V[_]=K),Rn.set(M,V))}function yn(_,M,I){let L=Rn.get(M)||{};for(let V in L)(_==null||V==_)&&(kd(V,M,L[V]),delete L[V]);_==null&&Rn.delete(M)}let en=0,fn=0,O=0,Lt=0,Qt=0,he=0,Et=Qt,ze=he,Wt=O,Kt=Lt,R=0,S=0,q=0,ft=0;n.bbox={};let at=!1,vt=!1,Mt=!1,nt=!1,st=!1,gt=!1;function F(_,M,I){(I||_!=n.width||M!=n.height)&&ot(_,M),pe(!1),Mt=!0,vt=!0,Vn()}function ot(_,M){n.width=en=O=_,n.height=fn=Lt=M,Qt=he=0,wt(),$t();let I=n.bbox;R=I.left=wr(Qt*Ie,.5),S=I.top=wr(he*Ie,.5),q=I.width=wr(O*Ie,.5),ft=I.height=wr(Lt*Ie,.5)}let it=3;function At(){let _=!1,M=0;for(;!_;){M++;let I=Nr(M),L=Yi(M);_=M==it||I&&L,_||(ot(n.width,n.height),vt=!0)}}function yt({width:_,height:M}){F(_,M)}n.setSize=yt;function wt(){let _=!1,M=!1,I=!1,L=!1;C.forEach((V,K)=>{if(V.show&&V._show){let{side:lt,_size:mt}=V,bt=lt%2,Ft=V.label!=null?V.labelSize:0,Ot=mt+Ft;Ot>0&&(bt?(O-=Ot,lt==3?(Qt+=Ot,L=!0):I=!0):(Lt-=Ot,lt==0?(he+=Ot,_=!0):M=!0))}}),qi[0]=_,qi[1]=I,qi[2]=M,qi[3]=L,O-=Ri[1]+Ri[3],Qt+=Ri[3],Lt-=Ri[2]+Ri[0],he+=Ri[0]}function $t(){let _=Qt+O,M=he+Lt,I=Qt,L=he;function V(K,lt){switch(K){case 1:return _+=lt,_-lt;case 2:return M+=lt,M-lt;case 3:return I-=lt,I+lt;case 0:return L-=lt,L+lt}}C.forEach((K,lt)=>{if(K.show&&K._show){let mt=K.side;K._pos=V(mt,K._size),K.label!=null&&(K._lpos=V(mt,K.labelSize))}})}if(dt.dataIdx==null){let _=dt.hover,M=_.skip=new Set(_.skip??[]);M.add(void 0);let I=_.prox=be(_.prox),L=_.bias??=0;dt.dataIdx=(V,K,lt,mt)=>{if(K==0)return lt;let bt=lt,Ft=I(V,K,lt,mt)??Ve,Ot=Ft>=0&&Ft<Ve,kt=N.ori==0?O:Lt,le=dt.left,Ce=t[0],Ee=t[K];if(M.has(Ee[lt])){bt=null;let ve=null,ee=null,Zt;if(L==0||L==-1)for(Zt=lt;ve==null&&Zt-- >0;)M.has(Ee[Zt])||(ve=Zt);if(L==0||L==1)for(Zt=lt;ee==null&&Zt++<Ee.length;)M.has(Ee[Zt])||(ee=Zt);if(ve!=null||ee!=null)if(Ot){let Ye=ve==null?-1/0:W(Ce[ve],N,kt,0),rn=ee==null?1/0:W(Ce[ee],N,kt,0),Dn=le-Ye,ke=rn-le;Dn<=ke?Dn<=Ft&&(bt=ve):ke<=Ft&&(bt=ee)}else bt=ee==null?ve:ve==null?ee:lt-ve<=ee-lt?ve:ee}else Ot&&Cn(le-W(Ce[lt],N,kt,0))>Ft&&(bt=null);return bt}}let ne=_=>{dt.event=_};dt.idxs=rt,dt._lock=!1;let ct=dt.points;ct.show=be(ct.show),ct.size=be(ct.size),ct.stroke=be(ct.stroke),ct.width=be(ct.width),ct.fill=be(ct.fill);let zt=n.focus=xn({},i.focus||{alpha:.3},dt.focus),ie=zt.prox>=0,It=ie&&ct.one,fe=[],Xe=[],Xn=[];function Go(_,M){let I=ct.show(n,M);if(I instanceof HTMLElement)return yi(I,L1),yi(I,_.class),us(I,-10,-10,O,Lt),g.insertBefore(I,fe[M]),I}function Ir(_,M){if(s==1||M>0){let I=s==1&&b[_.scale].time,L=_.value;_.value=I?b_(L)?P_(Z,R_(L,H)):L||tt:L||qA,_.label=_.label||(I?BA:OA)}if(It||M>0){_.width=_.width==null?1:_.width,_.paths=_.paths||oC||J1,_.fillTo=be(_.fillTo||KA),_.pxAlign=+Ae(_.pxAlign,y),_.pxRound=k_(_.pxAlign),_.stroke=be(_.stroke||null),_.fill=be(_.fill||null),_._stroke=_._fill=_._paths=_._focus=null;let I=$A(ii(1,_.width),1),L=_.points=xn({},{size:I,width:ii(1,I*.2),stroke:_.stroke,space:I*2,paths:aC,_stroke:null,_fill:null},_.points);L.show=be(L.show),L.filter=be(L.filter),L.fill=be(L.fill),L.stroke=be(L.stroke),L.paths=be(L.paths),L.pxAlign=_.pxAlign}if(et){let I=Be(_,M);ce.splice(M,0,I[0]),qt.splice(M,0,I[1]),pt.values.push(null)}if(xt){rt.splice(M,0,null);let I=null;It?M==0&&(I=Go(_,M)):M>0&&(I=Go(_,M)),fe.splice(M,0,I),Xe.splice(M,0,0),Xn.splice(M,0,0)}Ln("addSeries",M)}function Pu(_,M){M=M??v.length,_=s==1?Xd(_,M,L_,O_):Xd(_,M,{},F_),v.splice(M,0,_),Ir(v[M],M)}n.addSeries=Pu;function al(_){if(v.splice(_,1),et){pt.values.splice(_,1),qt.splice(_,1);let M=ce.splice(_,1)[0];yn(null,M.firstChild),M.remove()}xt&&(rt.splice(_,1),fe.splice(_,1)[0].remove(),Xe.splice(_,1),Xn.splice(_,1)),Ln("delSeries",_)}n.delSeries=al;let qi=[!1,!1,!1,!1];function fs(_,M){if(_._show=_.show,_.show){let I=_.side%2,L=b[_.scale];L==null&&(_.scale=I?v[1].scale:A,L=b[_.scale]);let V=L.time;_.size=be(_.size),_.space=be(_.space),_.rotate=be(_.rotate),ir(_.incrs)&&_.incrs.forEach(lt=>{!sr.has(lt)&&sr.set(lt,j_(lt))}),_.incrs=be(_.incrs||(L.distr==2?xA:V?m==1?vA:bA:Tr)),_.splits=be(_.splits||(V&&L.distr==1?ht:L.distr==3?Vd:L.distr==4?VA:zA)),_.stroke=be(_.stroke),_.grid.stroke=be(_.grid.stroke),_.ticks.stroke=be(_.ticks.stroke),_.border.stroke=be(_.border.stroke);let K=_.values;_.values=ir(K)&&!ir(K[0])?be(K):V?ir(K)?C_(Z,A_(K,H)):b_(K)?EA(Z,K):K||j:K||kA,_.filter=be(_.filter||(L.distr>=3&&L.log==10?WA:L.distr==3&&L.log==2?XA:J_)),_.font=H_(_.font),_.labelFont=H_(_.labelFont),_._size=_.size(n,null,M,0),_._space=_._rotate=_._incrs=_._found=_._splits=_._values=null,_._size>0&&(qi[M]=!0,_._el=Ai(C1,f))}}function ds(_,M,I,L){let[V,K,lt,mt]=I,bt=M%2,Ft=0;return bt==0&&(mt||K)&&(Ft=M==0&&!V||M==2&&!lt?An(I_.size/3):0),bt==1&&(V||lt)&&(Ft=M==1&&!K||M==3&&!mt?An(N_.size/2):0),Ft}let Ho=n.padding=(i.padding||[ds,ds,ds,ds]).map(_=>be(Ae(_,ds))),Ri=n._padding=Ho.map((_,M)=>_(n,M,qi,0)),nn,cn=null,hn=null,$i=s==1?v[0].idxs:null,ci=null,Us=!1;function Wo(_,M){if(t=_??[],n.data=n._data=t,s==2){nn=0;for(let I=1;I<v.length;I++)nn+=t[I][0].length}else{t.length==0&&(n.data=n._data=t=[[]]),ci=t[0],nn=ci.length;let I=t;if(z==2){I=t.slice();let L=I[0]=Array(nn);for(let V=0;V<nn;V++)L[V]=V}n._data=t=I}if(pe(!0),Ln("setData"),z==2&&(Mt=!0),M!==!1){let I=N;I.auto(n,Us)?Xo():Bs(A,I.min,I.max),nt=nt||dt.left>=0,gt=!0,Vn()}}n.setData=Wo;function Xo(){Us=!0;let _,M;s==1&&(nn>0?(cn=$i[0]=0,hn=$i[1]=nn-1,_=t[0][cn],M=t[0][hn],z==2?(_=cn,M=hn):_==M&&(z==3?[_,M]=mu(_,_,N.log,!1):z==4?[_,M]=Zd(_,_,N.log,!1):N.time?M=_+An(86400/m):[_,M]=fu(_,M,Jd,!0))):(cn=$i[0]=_=null,hn=$i[1]=M=null)),Bs(A,_,M)}let Lr,Fs,Dr,w,B,Q,Y,J,Ct,Dt;function Rt(_,M,I,L,V,K){_??=o_,I??=jd,L??="butt",V??=o_,K??="round",_!=Lr&&(u.strokeStyle=Lr=_),V!=Fs&&(u.fillStyle=Fs=V),M!=Dr&&(u.lineWidth=Dr=M),K!=B&&(u.lineJoin=B=K),L!=Q&&(u.lineCap=Q=L),I!=w&&u.setLineDash(w=I)}function Nt(_,M,I,L){M!=Fs&&(u.fillStyle=Fs=M),_!=Y&&(u.font=Y=_),I!=J&&(u.textAlign=J=I),L!=Ct&&(u.textBaseline=Ct=L)}function Gt(_,M,I,L,V=0){if(L.length>0&&_.auto(n,Us)&&(M==null||M.min==null)){let K=Ae(cn,0),lt=Ae(hn,L.length-1),mt=I.min==null?W1(L,K,lt,V,_.distr==3):[I.min,I.max];_.min=Wi(_.min,I.min=mt[0]),_.max=ii(_.max,I.max=mt[1])}}let re={min:null,max:null};function _e(){for(let L in b){let V=b[L];X[L]==null&&(V.min==null||X[A]!=null&&V.auto(n,Us))&&(X[L]=re)}for(let L in b){let V=b[L];X[L]==null&&V.from!=null&&X[V.from]!=null&&(X[L]=re)}X[A]!=null&&pe(!0);let _={};for(let L in X){let V=X[L];if(V!=null){let K=_[L]=Uo(b[L],Q1);if(V.min!=null)xn(K,V);else if(L!=A||s==2)if(nn==0&&K.from==null){let lt=K.range(n,null,null,L);K.min=lt[0],K.max=lt[1]}else K.min=Ve,K.max=-Ve}}if(nn>0){v.forEach((L,V)=>{if(s==1){let K=L.scale,lt=X[K];if(lt==null)return;let mt=_[K];if(V==0){let bt=mt.range(n,mt.min,mt.max,K);mt.min=bt[0],mt.max=bt[1],cn=Hi(mt.min,t[0]),hn=Hi(mt.max,t[0]),hn-cn>1&&(t[0][cn]<mt.min&&cn++,t[0][hn]>mt.max&&hn--),L.min=ci[cn],L.max=ci[hn]}else L.show&&L.auto&&Gt(mt,lt,L,t[V],L.sorted);L.idxs[0]=cn,L.idxs[1]=hn}else if(V>0&&L.show&&L.auto){let[K,lt]=L.facets,mt=K.scale,bt=lt.scale,[Ft,Ot]=t[V],kt=_[mt],le=_[bt];kt!=null&&Gt(kt,X[mt],K,Ft,K.sorted),le!=null&&Gt(le,X[bt],lt,Ot,lt.sorted),L.min=lt.min,L.max=lt.max}});for(let L in _){let V=_[L],K=X[L];if(V.from==null&&(K==null||K.min==null)){let lt=V.range(n,V.min==Ve?null:V.min,V.max==-Ve?null:V.max,L);V.min=lt[0],V.max=lt[1]}}}for(let L in _){let V=_[L];if(V.from!=null){let K=_[V.from];if(K.min==null)V.min=V.max=null;else{let lt=V.range(n,K.min,K.max,L);V.min=lt[0],V.max=lt[1]}}}let M={},I=!1;for(let L in _){let V=_[L],K=b[L];if(K.min!=V.min||K.max!=V.max){K.min=V.min,K.max=V.max;let lt=K.distr;K._min=lt==3?Is(K.min):lt==4?Ld(K.min,K.asinh):lt==100?K.fwd(K.min):K.min,K._max=lt==3?Is(K.max):lt==4?Ld(K.max,K.asinh):lt==100?K.fwd(K.max):K.max,M[L]=I=!0}}if(I){v.forEach((L,V)=>{s==2?V>0&&M.y&&(L._paths=null):M[L.scale]&&(L._paths=null)});for(let L in M)Mt=!0,Ln("setScale",L);xt&&dt.left>=0&&(nt=gt=!0)}for(let L in X)X[L]=null}function Vt(_){let M=zd(cn-1,0,nn-1),I=zd(hn+1,0,nn-1);for(;_[M]==null&&M>0;)M--;for(;_[I]==null&&I<nn-1;)I++;return[M,I]}function xe(){if(nn>0){let _=v.some(M=>M._focus)&&Dt!=zt.alpha;_&&(u.globalAlpha=Dt=zt.alpha),v.forEach((M,I)=>{if(I>0&&M.show&&(tn(I,!1),tn(I,!0),M._paths==null)){let L=Dt;Dt!=M.alpha&&(u.globalAlpha=Dt=M.alpha);let V=s==2?[0,t[I][0].length-1]:Vt(t[I]);M._paths=M.paths(n,I,V[0],V[1]),Dt!=L&&(u.globalAlpha=Dt=L)}}),v.forEach((M,I)=>{if(I>0&&M.show){let L=Dt;Dt!=M.alpha&&(u.globalAlpha=Dt=M.alpha),M._paths!=null&&Ue(I,!1);{let V=M._paths!=null?M._paths.gaps:null,K=M.points.show(n,I,cn,hn,V),lt=M.points.filter(n,I,K,V);(K||lt)&&(M.points._paths=M.points.paths(n,I,cn,hn,lt),Ue(I,!0))}Dt!=L&&(u.globalAlpha=Dt=L),Ln("drawSeries",I)}}),_&&(u.globalAlpha=Dt=1)}}function tn(_,M){let I=M?v[_].points:v[_];I._stroke=I.stroke(n,_),I._fill=I.fill(n,_)}function Ue(_,M){let I=M?v[_].points:v[_],{stroke:L,fill:V,clip:K,flags:lt,_stroke:mt=I._stroke,_fill:bt=I._fill,_width:Ft=I.width}=I._paths;Ft=Ge(Ft*Ie,3);let Ot=null,kt=Ft%2/2;M&&bt==null&&(bt=Ft>0?"#fff":mt);let le=I.pxAlign==1&&kt>0;if(le&&u.translate(kt,kt),!M){let Ce=R-Ft/2,Ee=S-Ft/2,ve=q+Ft,ee=ft+Ft;Ot=new Path2D,Ot.rect(Ce,Ee,ve,ee)}M?Bt(mt,Ft,I.dash,I.cap,bt,L,V,lt,K):Fe(_,mt,Ft,I.dash,I.cap,bt,L,V,lt,Ot,K),le&&u.translate(-kt,-kt)}function Fe(_,M,I,L,V,K,lt,mt,bt,Ft,Ot){let kt=!1;bt!=0&&P.forEach((le,Ce)=>{if(le.series[0]==_){let Ee=v[le.series[1]],ve=t[le.series[1]],ee=(Ee._paths||il).band;ir(ee)&&(ee=le.dir==1?ee[0]:ee[1]);let Zt,Ye=null;Ee.show&&ee&&q1(ve,cn,hn)?(Ye=le.fill(n,Ce)||K,Zt=Ee._paths.clip):ee=null,Bt(M,I,L,V,Ye,lt,mt,bt,Ft,Ot,Zt,ee),kt=!0}}),kt||Bt(M,I,L,V,K,lt,mt,bt,Ft,Ot)}let vn=Fo|Hd;function Bt(_,M,I,L,V,K,lt,mt,bt,Ft,Ot,kt){Rt(_,M,I,L,V),(bt||Ft||kt)&&(u.save(),bt&&u.clip(bt),Ft&&u.clip(Ft)),kt?(mt&vn)==vn?(u.clip(kt),Ot&&u.clip(Ot),Se(V,lt),dn(_,K,M)):mt&Hd?(Se(V,lt),u.clip(kt),dn(_,K,M)):mt&Fo&&(u.save(),u.clip(kt),Ot&&u.clip(Ot),Se(V,lt),u.restore(),dn(_,K,M)):(Se(V,lt),dn(_,K,M)),(bt||Ft||kt)&&u.restore()}function dn(_,M,I){I>0&&(M instanceof Map?M.forEach((L,V)=>{u.strokeStyle=Lr=V,u.stroke(L)}):M!=null&&_&&u.stroke(M))}function Se(_,M){M instanceof Map?M.forEach((I,L)=>{u.fillStyle=Fs=L,u.fill(I)}):M!=null&&_&&u.fill(M)}function ps(_,M,I,L){let V=C[_],K;if(L<=0)K=[0,0];else{let lt=V._space=V.space(n,_,M,I,L),mt=V._incrs=V.incrs(n,_,M,I,L,lt);K=dC(M,I,mt,L,lt)}return V._found=K}function pn(_,M,I,L,V,K,lt,mt,bt,Ft){let Ot=lt%2/2;y==1&&u.translate(Ot,Ot),Rt(mt,lt,bt,Ft,mt),u.beginPath();let kt,le,Ce,Ee,ve=V+(L==0||L==3?-K:K);I==0?(le=V,Ee=ve):(kt=V,Ce=ve);for(let ee=0;ee<_.length;ee++)M[ee]!=null&&(I==0?kt=Ce=_[ee]:le=Ee=_[ee],u.moveTo(kt,le),u.lineTo(Ce,Ee));u.stroke(),y==1&&u.translate(-Ot,-Ot)}function Nr(_){let M=!0;return C.forEach((I,L)=>{if(!I.show)return;let V=b[I.scale];if(V.min==null){I._show&&(M=!1,I._show=!1,pe(!1));return}else I._show||(M=!1,I._show=!0,pe(!1));let K=I.side,lt=K%2,{min:mt,max:bt}=V,[Ft,Ot]=ps(L,mt,bt,lt==0?O:Lt);if(Ot==0)return;let kt=V.distr==2,le=I._splits=I.splits(n,L,mt,bt,Ft,Ot,kt),Ce=V.distr==2?le.map(Zt=>ci[Zt]):le,Ee=V.distr==2?ci[le[1]]-ci[le[0]]:Ft,ve=I._values=I.values(n,I.filter(n,Ce,L,Ot,Ee),L,Ot,Ee);I._rotate=K==2?I.rotate(n,ve,L,Ot):0;let ee=I._size;I._size=Ci(I.size(n,ve,L,_)),ee!=null&&I._size!=ee&&(M=!1)}),M}function Yi(_){let M=!0;return Ho.forEach((I,L)=>{let V=I(n,L,qi,_);V!=Ri[L]&&(M=!1),Ri[L]=V}),M}function ms(){for(let _=0;_<C.length;_++){let M=C[_];if(!M.show||!M._show)continue;let I=M.side,L=I%2,V,K,lt=M.stroke(n,_),mt=I==0||I==3?-1:1,[bt,Ft]=M._found;if(M.label!=null){let Yn=M.labelGap*mt,fi=An((M._lpos+Yn)*Ie);Nt(M.labelFont[0],lt,"center",I==2?"top":r_),u.save(),L==1?(V=K=0,u.translate(fi,An(S+ft/2)),u.rotate((I==3?-hu:hu)/2)):(V=An(R+q/2),K=fi);let cr=Y_(M.label)?M.label(n,_,bt,Ft):M.label;u.fillText(cr,V,K),u.restore()}if(Ft==0)continue;let Ot=b[M.scale],kt=L==0?q:ft,le=L==0?R:S,Ce=M._splits,Ee=Ot.distr==2?Ce.map(Yn=>ci[Yn]):Ce,ve=Ot.distr==2?ci[Ce[1]]-ci[Ce[0]]:bt,ee=M.ticks,Zt=M.border,Ye=ee.show?ee.size:0,rn=An(Ye*Ie),Dn=An((M.alignTo==2?M._size-Ye-M.gap:M.gap)*Ie),ke=M._rotate*-hu/180,on=p(M._pos*Ie),hi=(rn+Dn)*mt,$n=on+hi;K=L==0?$n:0,V=L==1?$n:0;let Mi=M.font[0],Pi=M.align==1?Po:M.align==2?Rd:ke>0?Po:ke<0?Rd:L==0?"center":I==3?Rd:Po,Ki=ke||L==1?"middle":I==2?"top":r_;Nt(Mi,lt,Pi,Ki);let ui=M.font[1]*M.lineGap,bi=Ce.map(Yn=>p(a(Yn,Ot,kt,le))),Ii=M._values;for(let Yn=0;Yn<Ii.length;Yn++){let fi=Ii[Yn];if(fi!=null){L==0?V=bi[Yn]:K=bi[Yn],fi=""+fi;let cr=fi.indexOf(`
`)==-1?[fi]:fi.split(/\n/gm);for(let Zn=0;Zn<cr.length;Zn++){let Op=cr[Zn];ke?(u.save(),u.translate(V,K+Zn*ui),u.rotate(ke),u.fillText(Op,0,0),u.restore()):u.fillText(Op,V,K+Zn*ui)}}}ee.show&&pn(bi,ee.filter(n,Ee,_,Ft,ve),L,I,on,rn,Ge(ee.width*Ie,3),ee.stroke(n,_),ee.dash,ee.cap);let ji=M.grid;ji.show&&pn(bi,ji.filter(n,Ee,_,Ft,ve),L,L==0?2:1,L==0?S:R,L==0?ft:q,Ge(ji.width*Ie,3),ji.stroke(n,_),ji.dash,ji.cap),Zt.show&&pn([on],[1],L==0?1:0,L==0?1:2,L==1?S:R,L==1?ft:q,Ge(Zt.width*Ie,3),Zt.stroke(n,_),Zt.dash,Zt.cap)}Ln("drawAxes")}function pe(_){v.forEach((M,I)=>{I>0&&(M._paths=null,_&&(s==1?(M.min=null,M.max=null):M.facets.forEach(L=>{L.min=null,L.max=null})))})}let sn=!1,qn=!1,Oe=[];function mn(){qn=!1;for(let _=0;_<Oe.length;_++)Ln(...Oe[_]);Oe.length=0}function Vn(){sn||(oA(yp),sn=!0)}function ll(_,M=!1){sn=!0,qn=M,_(n),yp(),M&&Oe.length>0&&queueMicrotask(mn)}n.batch=ll;function yp(){if(at&&(_e(),at=!1),Mt&&(At(),Mt=!1),vt){if(Je(d,Po,Qt),Je(d,"top",he),Je(d,Qa,O),Je(d,tl,Lt),Je(g,Po,Qt),Je(g,"top",he),Je(g,Qa,O),Je(g,tl,Lt),Je(f,Qa,en),Je(f,tl,fn),h.width=An(en*Ie),h.height=An(fn*Ie),C.forEach(({_el:_,_show:M,_size:I,_pos:L,side:V})=>{if(_!=null)if(M){let K=V===3||V===0?I:0,lt=V%2==1;Je(_,lt?"left":"top",L-K),Je(_,lt?"width":"height",I),Je(_,lt?"top":"left",lt?he:Qt),Je(_,lt?"height":"width",lt?Lt:O),Bd(_,Er)}else yi(_,Er)}),Lr=Fs=Dr=B=Q=Y=J=Ct=w=null,Dt=1,Yo(!0),Qt!=Et||he!=ze||O!=Wt||Lt!=Kt){pe(!1);let _=O/Wt,M=Lt/Kt;if(xt&&!nt&&dt.left>=0){dt.left*=_,dt.top*=M,Ur&&us(Ur,An(dt.left),0,O,Lt),Fr&&us(Fr,0,An(dt.top),O,Lt);for(let I=0;I<fe.length;I++){let L=fe[I];L!=null&&(Xe[I]*=_,Xn[I]*=M,us(L,Ci(Xe[I]),Ci(Xn[I]),O,Lt))}}if($e.show&&!st&&$e.left>=0&&$e.width>0){$e.left*=_,$e.width*=_,$e.top*=M,$e.height*=M;for(let I in Fu)Je(kr,I,$e[I])}Et=Qt,ze=he,Wt=O,Kt=Lt}Ln("setSize"),vt=!1}en>0&&fn>0&&(u.clearRect(0,0,h.width,h.height),Ln("drawClear"),T.forEach(_=>_()),Ln("draw")),$e.show&&st&&(cl($e),st=!1),xt&&nt&&(lr(null,!0,!1),nt=!1),pt.show&&pt.live&&gt&&(Nu(),gt=!1),l||(l=!0,n.status=1,Ln("ready")),Us=!1,sn=!1}n.redraw=(_,M)=>{Mt=M||!1,_!==!1?Bs(A,N.min,N.max):Vn()};function Iu(_,M){let I=b[_];if(I.from==null){if(nn==0){let L=I.range(n,M.min,M.max,_);M.min=L[0],M.max=L[1]}if(M.min>M.max){let L=M.min;M.min=M.max,M.max=L}if(nn>1&&M.min!=null&&M.max!=null&&M.max-M.min<1e-16)return;_==A&&I.distr==2&&nn>0&&(M.min=Hi(M.min,t[0]),M.max=Hi(M.max,t[0]),M.min==M.max&&M.max++),X[_]=M,at=!0,Vn()}}n.setScale=Iu;let Lu,Du,Ur,Fr,vp,Sp,Or,Br,Mp,bp,qe,je,Os=!1,On=dt.drag,Pn=On.x,In=On.y;xt&&(dt.x&&(Lu=Ai(P1,g)),dt.y&&(Du=Ai(I1,g)),N.ori==0?(Ur=Lu,Fr=Du):(Ur=Du,Fr=Lu),qe=dt.left,je=dt.top);let $e=n.select=xn({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),kr=$e.show?Ai(R1,$e.over?g:d):null;function cl(_,M){if($e.show){for(let I in _)$e[I]=_[I],I in Fu&&Je(kr,I,_[I]);M!==!1&&Ln("setSelect")}}n.setSelect=cl;function cy(_){if(v[_].show)et&&Bd(ce[_],Er);else if(et&&yi(ce[_],Er),xt){let I=It?fe[0]:fe[_];I!=null&&us(I,-10,-10,O,Lt)}}function Bs(_,M,I){Iu(_,{min:M,max:I})}function Zi(_,M,I,L){M.focus!=null&&py(_),M.show!=null&&v.forEach((V,K)=>{K>0&&(_==K||_==null)&&(V.show=M.show,cy(K),s==2?(Bs(V.facets[0].scale,null,null),Bs(V.facets[1].scale,null,null)):Bs(V.scale,null,null),Vn())}),I!==!1&&Ln("setSeries",_,M),L&&Zo("setSeries",n,_,M)}n.setSeries=Zi;function hy(_,M){xn(P[_],M)}function uy(_,M){_.fill=be(_.fill||null),_.dir=Ae(_.dir,-1),M=M??P.length,P.splice(M,0,_)}function fy(_){_==null?P.length=0:P.splice(_,1)}n.addBand=uy,n.setBand=hy,n.delBand=fy;function dy(_,M){v[_].alpha=M,xt&&fe[_]!=null&&(fe[_].style.opacity=M),et&&ce[_]&&(ce[_].style.opacity=M)}let gs,ks,ar,zr={focus:!0};function py(_){if(_!=ar){let M=_==null,I=zt.alpha!=1;v.forEach((L,V)=>{if(s==1||V>0){let K=M||V==0||V==_;L._focus=M?null:K,I&&dy(V,K?1:zt.alpha)}}),ar=_,I&&Vn()}}et&&ie&&we(c_,Pt,_=>{dt._lock||(ne(_),ar!=null&&Zi(null,zr,!0,gn.setSeries))});function Ji(_,M,I){let L=b[M];I&&(_=_/Ie-(L.ori==1?he:Qt));let V=O;L.ori==1&&(V=Lt,_=V-_),L.dir==-1&&(_=V-_);let K=L._min,lt=L._max,mt=_/V,bt=K+(lt-K)*mt,Ft=L.distr;return Ft==3?Do(10,bt):Ft==4?Y1(bt,L.asinh):Ft==100?L.bwd(bt):bt}function my(_,M){let I=Ji(_,A,M);return Hi(I,t[0],cn,hn)}n.valToIdx=_=>Hi(_,t[0]),n.posToIdx=my,n.posToVal=Ji,n.valToPos=(_,M,I)=>b[M].ori==0?r(_,b[M],I?q:O,I?R:0):o(_,b[M],I?ft:Lt,I?S:0),n.setCursor=(_,M,I)=>{qe=_.left,je=_.top,lr(null,M,I)};function wp(_,M){Je(kr,Po,$e.left=_),Je(kr,Qa,$e.width=M)}function Tp(_,M){Je(kr,"top",$e.top=_),Je(kr,tl,$e.height=M)}let qo=N.ori==0?wp:Tp,$o=N.ori==1?wp:Tp;function gy(){if(et&&pt.live)for(let _=s==2?1:0;_<v.length;_++){if(_==0&&de)continue;let M=pt.values[_],I=0;for(let L in M)qt[_][I++].firstChild.nodeValue=M[L]}}function Nu(_,M){if(_!=null&&(_.idxs?_.idxs.forEach((I,L)=>{rt[L]=I}):j1(_.idx)||rt.fill(_.idx),pt.idx=rt[0]),et&&pt.live){for(let I=0;I<v.length;I++)(I>0||s==1&&!de)&&_y(I,rt[I]);gy()}gt=!1,M!==!1&&Ln("setLegend")}n.setLegend=Nu;function _y(_,M){let I=v[_],L=_==0&&z==2?ci:t[_],V;de?V=I.values(n,_,M)??ae:(V=I.value(n,M==null?null:L[M],_,M),V=V==null?ae:{_:V}),pt.values[_]=V}function lr(_,M,I){Mp=qe,bp=je,[qe,je]=dt.move(n,qe,je),dt.left=qe,dt.top=je,xt&&(Ur&&us(Ur,An(qe),0,O,Lt),Fr&&us(Fr,0,An(je),O,Lt));let L,V=cn>hn;gs=Ve,ks=null;let K=N.ori==0?O:Lt,lt=N.ori==1?O:Lt;if(qe<0||nn==0||V){L=dt.idx=null;for(let mt=0;mt<v.length;mt++){let bt=fe[mt];bt!=null&&us(bt,-10,-10,O,Lt)}ie&&Zi(null,zr,!0,_==null&&gn.setSeries),pt.live&&(rt.fill(L),gt=!0)}else{let mt,bt,Ft;s==1&&(mt=N.ori==0?qe:je,bt=Ji(mt,A),L=dt.idx=Hi(bt,t[0],cn,hn),Ft=W(t[0][L],N,K,0));let Ot=-10,kt=-10,le=0,Ce=0,Ee=!0,ve="",ee="";for(let Zt=s==2?1:0;Zt<v.length;Zt++){let Ye=v[Zt],rn=rt[Zt],Dn=rn==null?null:s==1?t[Zt][rn]:t[Zt][1][rn],ke=dt.dataIdx(n,Zt,L,bt),on=ke==null?null:s==1?t[Zt][ke]:t[Zt][1][ke];if(gt=gt||on!=Dn||ke!=rn,rt[Zt]=ke,Zt>0&&Ye.show){let hi=ke==null?-10:ke==L?Ft:W(s==1?t[0][ke]:t[Zt][0][ke],N,K,0),$n=on==null?-10:D(on,s==1?b[Ye.scale]:b[Ye.facets[1].scale],lt,0);if(ie&&on!=null){let Mi=N.ori==1?qe:je,Pi=Cn(zt.dist(n,Zt,ke,$n,Mi));if(Pi<gs){let Ki=zt.bias;if(Ki!=0){let ui=Ji(Mi,Ye.scale),bi=on>=0?1:-1,Ii=ui>=0?1:-1;Ii==bi&&(Ii==1?Ki==1?on>=ui:on<=ui:Ki==1?on<=ui:on>=ui)&&(gs=Pi,ks=Zt)}else gs=Pi,ks=Zt}}if(gt||It){let Mi,Pi;N.ori==0?(Mi=hi,Pi=$n):(Mi=$n,Pi=hi);let Ki,ui,bi,Ii,ji,Yn,fi=!0,cr=ct.bbox;if(cr!=null){fi=!1;let Zn=cr(n,Zt);bi=Zn.left,Ii=Zn.top,Ki=Zn.width,ui=Zn.height}else bi=Mi,Ii=Pi,Ki=ui=ct.size(n,Zt);if(Yn=ct.fill(n,Zt),ji=ct.stroke(n,Zt),It)Zt==ks&&gs<=zt.prox&&(Ot=bi,kt=Ii,le=Ki,Ce=ui,Ee=fi,ve=Yn,ee=ji);else{let Zn=fe[Zt];Zn!=null&&(Xe[Zt]=bi,Xn[Zt]=Ii,g_(Zn,Ki,ui,fi),p_(Zn,Yn,ji),us(Zn,Ci(bi),Ci(Ii),O,Lt))}}}}if(It){let Zt=zt.prox,Ye=ar==null?gs<=Zt:gs>Zt||ks!=ar;if(gt||Ye){let rn=fe[0];rn!=null&&(Xe[0]=Ot,Xn[0]=kt,g_(rn,le,Ce,Ee),p_(rn,ve,ee),us(rn,Ci(Ot),Ci(kt),O,Lt))}}}if($e.show&&Os)if(_!=null){let[mt,bt]=gn.scales,[Ft,Ot]=gn.match,[kt,le]=_.cursor.sync.scales,Ce=_.cursor.drag;if(Pn=Ce._x,In=Ce._y,Pn||In){let{left:Ee,top:ve,width:ee,height:Zt}=_.select,Ye=_.scales[kt].ori,rn=_.posToVal,Dn,ke,on,hi,$n,Mi=mt!=null&&Ft(mt,kt),Pi=bt!=null&&Ot(bt,le);Mi&&Pn?(Ye==0?(Dn=Ee,ke=ee):(Dn=ve,ke=Zt),on=b[mt],hi=W(rn(Dn,kt),on,K,0),$n=W(rn(Dn+ke,kt),on,K,0),qo(Wi(hi,$n),Cn($n-hi))):qo(0,K),Pi&&In?(Ye==1?(Dn=Ee,ke=ee):(Dn=ve,ke=Zt),on=b[bt],hi=D(rn(Dn,le),on,lt,0),$n=D(rn(Dn+ke,le),on,lt,0),$o(Wi(hi,$n),Cn($n-hi))):$o(0,lt)}else Ou()}else{let mt=Cn(Mp-vp),bt=Cn(bp-Sp);if(N.ori==1){let le=mt;mt=bt,bt=le}Pn=On.x&&mt>=On.dist,In=On.y&&bt>=On.dist;let Ft=On.uni;Ft!=null?Pn&&In&&(Pn=mt>=Ft,In=bt>=Ft,!Pn&&!In&&(bt>mt?In=!0:Pn=!0)):On.x&&On.y&&(Pn||In)&&(Pn=In=!0);let Ot,kt;Pn&&(N.ori==0?(Ot=Or,kt=qe):(Ot=Br,kt=je),qo(Wi(Ot,kt),Cn(kt-Ot)),In||$o(0,lt)),In&&(N.ori==1?(Ot=Or,kt=qe):(Ot=Br,kt=je),$o(Wi(Ot,kt),Cn(kt-Ot)),Pn||qo(0,K)),!Pn&&!In&&(qo(0,0),$o(0,0))}if(On._x=Pn,On._y=In,_==null){if(I){if(Fp!=null){let[mt,bt]=gn.scales;gn.values[0]=mt!=null?Ji(N.ori==0?qe:je,mt):null,gn.values[1]=bt!=null?Ji(N.ori==1?qe:je,bt):null}Zo(Pd,n,qe,je,O,Lt,L)}if(ie){let mt=I&&gn.setSeries,bt=zt.prox;ar==null?gs<=bt&&Zi(ks,zr,!0,mt):gs>bt?Zi(null,zr,!0,mt):ks!=ar&&Zi(ks,zr,!0,mt)}}gt&&(pt.idx=L,Nu()),M!==!1&&Ln("setCursor")}let zs=null;Object.defineProperty(n,"rect",{get(){return zs==null&&Yo(!1),zs}});function Yo(_=!1){_?zs=null:(zs=g.getBoundingClientRect(),Ln("syncRect",zs))}function Ep(_,M,I,L,V,K,lt){dt._lock||Os&&_!=null&&_.movementX==0&&_.movementY==0||(Uu(_,M,I,L,V,K,lt,!1,_!=null),_!=null?lr(null,!0,!0):lr(M,!0,!1))}function Uu(_,M,I,L,V,K,lt,mt,bt){if(zs==null&&Yo(!1),ne(_),_!=null)I=_.clientX-zs.left,L=_.clientY-zs.top;else{if(I<0||L<0){qe=-10,je=-10;return}let[Ft,Ot]=gn.scales,kt=M.cursor.sync,[le,Ce]=kt.values,[Ee,ve]=kt.scales,[ee,Zt]=gn.match,Ye=M.axes[0].side%2==1,rn=N.ori==0?O:Lt,Dn=N.ori==1?O:Lt,ke=Ye?K:V,on=Ye?V:K,hi=Ye?L:I,$n=Ye?I:L;if(Ee!=null?I=ee(Ft,Ee)?a(le,b[Ft],rn,0):-10:I=rn*(hi/ke),ve!=null?L=Zt(Ot,ve)?a(Ce,b[Ot],Dn,0):-10:L=Dn*($n/on),N.ori==1){let Mi=I;I=L,L=Mi}}bt&&(M==null||M.cursor.event.type==Pd)&&((I<=1||I>=O-1)&&(I=wr(I,O)),(L<=1||L>=Lt-1)&&(L=wr(L,Lt))),mt?(vp=I,Sp=L,[Or,Br]=dt.move(n,I,L)):(qe=I,je=L)}let Fu={width:0,height:0,left:0,top:0};function Ou(){cl(Fu,!1)}let Ap,Cp,Rp,Pp;function Ip(_,M,I,L,V,K,lt){Os=!0,Pn=In=On._x=On._y=!1,Uu(_,M,I,L,V,K,lt,!0,!1),_!=null&&(we(Id,Fd,Lp,!1),Zo(a_,n,Or,Br,O,Lt,null));let{left:mt,top:bt,width:Ft,height:Ot}=$e;Ap=mt,Cp=bt,Rp=Ft,Pp=Ot}function Lp(_,M,I,L,V,K,lt){Os=On._x=On._y=!1,Uu(_,M,I,L,V,K,lt,!1,!0);let{left:mt,top:bt,width:Ft,height:Ot}=$e,kt=Ft>0||Ot>0,le=Ap!=mt||Cp!=bt||Rp!=Ft||Pp!=Ot;if(kt&&le&&cl($e),On.setScale&&kt&&le){let Ce=mt,Ee=Ft,ve=bt,ee=Ot;if(N.ori==1&&(Ce=bt,Ee=Ot,ve=mt,ee=Ft),Pn&&Bs(A,Ji(Ce,A),Ji(Ce+Ee,A)),In)for(let Zt in b){let Ye=b[Zt];Zt!=A&&Ye.from==null&&Ye.min!=Ve&&Bs(Zt,Ji(ve+ee,Zt),Ji(ve,Zt))}Ou()}else dt.lock&&(dt._lock=!dt._lock,lr(M,!0,_!=null));_!=null&&(yn(Id,Fd),Zo(Id,n,qe,je,O,Lt,null))}function xy(_,M,I,L,V,K,lt){if(dt._lock)return;ne(_);let mt=Os;if(Os){let bt=!0,Ft=!0,Ot=10,kt,le;N.ori==0?(kt=Pn,le=In):(kt=In,le=Pn),kt&&le&&(bt=qe<=Ot||qe>=O-Ot,Ft=je<=Ot||je>=Lt-Ot),kt&&bt&&(qe=qe<Or?0:O),le&&Ft&&(je=je<Br?0:Lt),lr(null,!0,!0),Os=!1}qe=-10,je=-10,rt.fill(null),lr(null,!0,!0),mt&&(Os=mt)}function Dp(_,M,I,L,V,K,lt){dt._lock||(ne(_),Xo(),Ou(),_!=null&&Zo(h_,n,qe,je,O,Lt,null))}function Np(){C.forEach(pC),F(n.width,n.height,!0)}Ar(uu,Lo,Np);let Vr={};Vr.mousedown=Ip,Vr.mousemove=Ep,Vr.mouseup=Lp,Vr.dblclick=Dp,Vr.setSeries=(_,M,I,L)=>{let V=gn.match[2];I=V(n,M,I),I!=-1&&Zi(I,L,!0,!1)},xt&&(we(a_,g,Ip),we(Pd,g,Ep),we(l_,g,_=>{ne(_),Yo(!1)}),we(c_,g,xy),we(h_,g,Dp),Wd.add(n),n.syncRect=Yo);let hl=n.hooks=i.hooks||{};function Ln(_,M,I){qn?Oe.push([_,M,I]):_ in hl&&hl[_].forEach(L=>{L.call(null,n,M,I)})}(i.plugins||[]).forEach(_=>{for(let M in _.hooks)hl[M]=(hl[M]||[]).concat(_.hooks[M])});let Up=(_,M,I)=>I,gn=xn({key:null,setSeries:!1,filters:{pub:S_,sub:S_},scales:[A,v[1]?v[1].scale:null],match:[M_,M_,Up],values:[null,null]},dt.sync);gn.match.length==2&&gn.match.push(Up),dt.sync=gn;let Fp=gn.key,Bu=xx(Fp);function Zo(_,M,I,L,V,K,lt){gn.filters.pub(_,M,I,L,V,K,lt)&&Bu.pub(_,M,I,L,V,K,lt)}Bu.sub(n);function yy(_,M,I,L,V,K,lt){gn.filters.sub(_,M,I,L,V,K,lt)&&Vr[_](null,M,I,L,V,K,lt)}n.pub=yy;function vy(){Bu.unsub(n),Wd.delete(n),Rn.clear(),kd(uu,Lo,Np),c.remove(),Pt?.remove(),Ln("destroy")}n.destroy=vy;function ku(){Ln("init",i,t),Wo(t||i.data,!1),X[A]?Iu(A,X[A]):Xo(),st=$e.show&&($e.width>0||$e.height>0),nt=gt=!0,F(i.width,i.height)}return v.forEach(Ir),C.forEach(fs),e?e instanceof HTMLElement?(e.appendChild(c),ku()):e(n,ku):ku(),n}zn.assign=xn;zn.fmtNum=Kd;zn.rangeNum=fu;zn.rangeLog=mu;zn.rangeAsinh=Zd;zn.orient=Rr;zn.pxRatio=Ie;zn.join=rA;zn.fmtDate=Qd,zn.tzDate=gA;zn.sync=xx;{zn.addGap=jA,zn.clipGaps=xu;let i=zn.paths={points:wx};i.linear=Ex,i.stepped=eC,i.bars=nC,i.spline=sC}var Ix=20,mC=26,gC=["align","lower"],_C=["up","align x","align depth","approach","fine"],Px={stroke:"#9fb0bd",grid:{stroke:"#263642",width:1},ticks:{show:!1},font:"11px system-ui"},op=(i,t)=>({label:i,stroke:t,width:1.5,points:{show:!1}});function xC(i){let t=()=>({width:Math.max(i.clientWidth,120),height:Math.min(Math.max(i.clientHeight-mC,60),118)}),e=new zn({...t(),legend:{show:!0,live:!1},cursor:{show:!1},scales:{x:{time:!1,range:[-Ix,0]}},axes:[{...Px,size:22,values:(n,s)=>s.map(r=>`${r} s`)},{...Px,size:38}],series:[{},op("x px","#4fb3ff"),op("y px","#7fd18b"),op("d mm","#f2a33a")]},[[],[],[],[]],i);return new ResizeObserver(()=>e.setSize(t())).observe(i),e}function Lx(i){let t=_t("servo-plot"),e=xC(t),n=[],s=[[],[],[]],r=()=>{for(let h of[n,...s])h.length=0},o=si(()=>{let h=n[n.length-1];e.setData([n.map(u=>Math.round((u-h)*100)/100),...s]),t.classList.toggle("empty",n.length===0)}),a=!1,l,c=()=>{let[,h,u]=l??[],f=n.length?` since ${We(n[n.length-1]*1e6)}`:"";_t("servo-note").textContent=a&&l?`${_C[h]??h}: ${$(u)}`:`at rest${f}`,t.classList.toggle("ended",!a),o()};i.follow("(micro-task ?i ?step ?state)",([h])=>{let[,,u,f]=h?ut(h):[];a=$(f)==="running"&&gC.includes($(u[0])),c()}),i.follow("(servo ?state ?object ?x ?y ?d)",([h])=>{if(l=h&&ut(h),!h||!l)return r(),c();let u=h.facts[0].when/1e6;for(u<n[n.length-1]&&r(),n.push(u),l.slice(3).forEach((f,d)=>s[d].push(f));n[0]<u-Ix;)for(let f of[n,...s])f.shift();c()})}var yC=1e3,vC="Escape, from anywhere",lp="use the button at the cell";function Mu(i){_t("stop-alarm").textContent=i,_t("stop-alarm").hidden=i===""}var cp=i=>_t("stop-note").textContent=i;async function ap(i){let t=setTimeout(()=>Mu(`STOP is not confirmed: ${lp}`),yC),e=n=>{clearTimeout(t),Mu(`STOP is not confirmed: ${lp} (${Te(n)})`)};try{await i.stop("the operator's STOP",e),cp("STOP is told"),Mu("")}catch(n){e(n)}clearTimeout(t)}function SC(i){_t("stop").addEventListener("click",()=>ap(i)),_t("confirm-stop").addEventListener("click",()=>{ap(i),_t("confirm").close()});let t=e=>{e.key==="Escape"&&!e.repeat&&ap(i)};window.addEventListener("keydown",t,{capture:!0})}async function MC(i){if(await Tl("Is everybody out of the way? Clearing the stop lets the arm move again."))try{await i.clearStops()}catch(t){cp(Te(t))}}function Dx(i,t,e){SC(i);let n=_t("clear-stops");n.addEventListener("click",()=>MC(i));let s=new Mn("why-not-cleared");n.after(s.note);let r=new Mn("why-no-stop");_t("stop-note").after(r.note),e.onChange(()=>{let o=t.right("clear-stops")||e.why;s.set("Clear",[n],o&&`${o}. Who clears a stop sets the arm free`);let a=t.right("stop");r.set("STOP",[_t("stop"),_t("confirm-stop")],a&&`${a}: ${lp}`)}),i.followAlways("(stop ?who ?reason)",o=>{_t("stopped").hidden=o.length===0,o.length>0?Mu(""):cp(vC);let a=o.map(l=>`${Bn($(ut(l)[1]),e.me)}: ${$(ut(l)[2])}`);_t("stopped-by").textContent=Xt(a.join("; "))})}function Nx(i,t){let e=i.map(ut).filter(a=>a[1]<=t),n=e.findLast(([,,a,l])=>$(a)==="operation"&&/^operation \d+:/.test($(l)));if(!n)return null;let s=Number($(n[3]).match(/\d+/)?.[0])-1,o=e.filter(a=>a[1]<n[1]).map(a=>xs(a[4])).findLast(a=>a&&a.operations[s]!==void 0&&te(a.operations[s])===te(n[4]));return o?{...o,step:s}:null}async function Ux(i,t,e){try{return{answers:await i.askThen(t,e),then:!0}}catch{return{answers:[],then:!1}}}async function bC(i,{goal:t,operations:e,step:n},s){let r=[Ht("plan-needs"),Ht("?n"),Ht("?needs")],{answers:o,then:a}=await Ux(i,te(r),s),[l]=(a?o:await i.ask(r)).map(ut);return!l||l[1]!==t||l[2].length!==e.length+1?null:{before:l[2][n],after:l[2][n+1]}}var wC=(i,t)=>Array.isArray(i)&&$(i[0])==="not"?!t.has(te(i[1])):t.has(te(i));function hp(i,t){if(i.length===0)return"nothing";let e=i.map(n=>{let s=t&&wC(n,t),r=s===null?"":s?" holds":" does not hold";return E("li",{class:s===!1?"lacks":""},E("code",{},Xt(te(n),120)),E("small",{class:"quiet"},r))});return E("ul",{class:"expected"},...e)}var TC=({operations:i,step:t})=>E("ol",{class:"ordered"},...i.map((e,n)=>E("li",{"aria-current":n===t?"step":null},E("code",{},Xt(te(e),120))))),EC=i=>E("dl",{class:"why"},...i.flatMap(([t,e])=>[E("dt",{},t),E("dd",{},e)]));async function Fx(i,t,e){let[,n,s]=ut(e),{when:r}=e.facts[0],o=Nx(t,n);if(!o||!["operation","servo","difference","missing"].includes($(s)))return"";let[a]=(await i.ask([Ht("goal"),o.goal,Ht("?facts")])).map(ut),l=await Ux(i,"(believed ?fact)",r),c=l.answers.map(d=>ut(d)[1]),h=l.then?new Set(c.map(te)):null,u=await bC(i,o,r),f="not known: the plan is not there any more, and no journal has it";return EC([["Ordered by",`goal ${te(o.goal)}${a?`: ${Xt(a[2].map(te).join(" "),300)}`:""}`],[`Step ${o.step+1} of ${o.operations.length}`,TC(o)],["Expected before",u?hp(u.before,h):f],["Expected after",u?hp(u.after,null):f],["Believed then",h?hp(c,null):"not known: this board keeps no journal"]])}var up=50,AC={reached:"good",running:"busy",kept:"good"},CC=i=>Array.isArray(i)&&$(i[0])==="fail"?$(i[2]):"";function Ox(i){let t=E("span",{class:"quiet"},""),e=E("tbody",{}),n=["","Goal","Outcome","Since"].map(l=>E("th",{},l)),s=E("table",{id:"goals"},E("thead",{},E("tr",{},...n)),e),r=new Map,o=new Map,a=()=>{let l=[...new Set([...r.keys(),...o.keys()])].sort((h,u)=>u-h);t.textContent=l.length>up?`${l.length}, ${up} shown`:String(l.length);let c=l.slice(0,up).map(h=>{let u=o.get(h),f=u?$(ut(u)[2]):"asked for",d=u?CC(ut(u)[3]):"";return E("tr",{},E("td",{},String(h)),E("td",{},E("code",{},Xt((r.get(h)??[]).map(te).join(" "),200))),E("td",{},E("span",{class:`chip ${AC[f]??"warn"}`},f),d&&` ${Xt(d)}`),E("td",{},u?We(u.facts[0].when):""))});e.replaceChildren(...c)};return i.follow("(goal ?n ?facts)",l=>{r=new Map(l.map(ut).map(([,c,h])=>[c,h])),a()}),i.follow("(goal-state ?n ?state ?detail)",l=>{o=new Map(l.map(c=>[ut(c)[1],c])),a()}),E("details",{class:"goals"},E("summary",{},"Goals so far ",t),s)}function Bx(i,t,e){let n=E("canvas",{role:"img","aria-label":`What was seen at ${We(e)}`,hidden:!0}),s=E("figcaption",{class:"quiet"},"looking for the picture \u2026");return(async()=>{if(!t)return s.textContent="no stream of images is told";try{let o=await i.picture(t,e);Hl(n,o),o.bitmap.close(),n.hidden=!1,s.textContent=`frame ${o.number}, ${We(o.captured)}`}catch(o){s.textContent=Te(o)}})(),E("figure",{class:"kept"},n,s)}var fp=20;function RC({answer:{ids:i,facts:t},label:e}){let n=E("summary",{},E("time",{},We(t[0].when)),Xt(e));return E("details",{},n,E("p",{class:"quiet"},Xr(i[0],t[0])))}var bu=class{#t;panel=E("div",{class:"timeline",id:"opened",hidden:!0});constructor(t){this.#t=t}open(t){let e=E("button",{type:"button",class:"small",onclick:()=>this.panel.hidden=!0},"Close"),n=t.slice(0,fp).map(r=>ut(r.answer)[0].name==="event"?this.#t(r.answer):RC(r)),s=t.length>fp?[E("p",{class:"quiet"},`and ${t.length-fp} more`)]:[];this.panel.replaceChildren(e,...n,...s),this.panel.hidden=!1,n[0].open=!0}};var PC=4e3,dp=({answer:i})=>i.facts[0].when,wu=class{#t={servo:new Map,sightings:new Map};#e=null;#n;constructor(t,e){this.#n=e,t.followAlways("(servo ?state ?object ?x ?y ?d)",([n])=>this.#r(n)),t.followAlways("(tracked ?eyes ?name ?state ?frame ?confidence)",n=>{for(let s of n)this.#s("sightings",{answer:s,until:s.facts[0].when});e()}),t.earlierWork((n,s)=>{for(let r of s)this.#s(n,r);e()})}servo(t){return this.#i("servo",t)}sightings(t){return this.#i("sightings",t)}#i(t,e){return[...this.#t[t].values()].filter(n=>dp(n)<=e)}#s(t,e){let n=this.#t[t];if(n.set(e.answer.ids[0],e),n.size<=PC)return;let s=[...n].reduce((r,o)=>dp(o[1])<dp(r[1])?o:r);n.delete(s[0])}#r(t){let e=n=>ut(n).slice(1,3).join(" ");t&&this.#e&&(this.#e.until=t.facts[0].when),t?(!this.#e||e(this.#e.answer)!==e(t))&&(this.#e={answer:t,until:t.facts[0].when},this.#s("servo",this.#e)):this.#e=null,this.#n()}};var Ds=["Goals","Plans","Operations","Servo","Sightings","Differences","Refusals","Faults"],IC=["up","align x","align depth","approach","fine"],LC={plan:"Plans",operation:"Operations",servo:"Servo",difference:"Differences",missing:"Differences",agent:"Faults"},DC=new Set(["operation","plan","result","goal"]),rr=i=>i.facts[0].when,NC=i=>Array.isArray(i)&&$(i[0])==="fail";function kx(i){let t=i.map(e=>({answer:e,event:ut(e),when:rr(e)}));return t.flatMap(({answer:e,event:[,,n,s,r],when:o},a)=>{let l=NC(r),c=l?"Faults":LC[$(n)];if(!c)return[];let h=c==="Operations"&&t.slice(a+1).find(({event:u})=>DC.has($(u[2])));return[{lane:c,from:o,until:h?h.when:o,kind:l?"bad":$(n),label:$(s),answer:e}]})}function zx(i,t,e){let n=new Map(t.map(s=>[ut(s)[1],s]));return i.flatMap(s=>{let[,r,o]=ut(s),a=n.get(r),l=a?$(ut(a)[2]):"asked for",c=`goal ${r} ${l}: ${o.map(te).join(" ")}`,h=a&&l!=="running"?rr(a):e,u={lane:"Goals",from:rr(s),until:h,kind:l,label:c,answer:a??s};return l==="refused"?[u,{...u,lane:"Refusals",from:h,kind:"bad"}]:[u]})}function Vx(i){return i.map(t=>{let[,e,n,s,r]=ut(t),o=`${$(e)}: ${$(n)}, ${s} times: ${$(r)}`;return{lane:"Refusals",from:rr(t),until:rr(t),kind:"bad",label:o,answer:t}})}function Gx(i){return i.map(({answer:t})=>{let[,e,n,s,r]=ut(t),o=`${$(e)}: ${$(n)} ${$(s)} since frame ${r}`;return{lane:"Sightings",from:rr(t),until:rr(t),kind:$(s),label:o,answer:t}})}function Hx(i){return i.map(({answer:t,until:e})=>{let[,n,s]=ut(t),r=`servo ${IC[n]??n}: ${$(s)}`;return{lane:"Servo",from:rr(t),until:e,kind:`state-${n}`,label:r,answer:t}})}function Wx(i,t){let e=[],n=new Map;for(let s of i.toSorted((r,o)=>r.from-o.from)){let r=`${s.lane} ${s.kind}`,o=n.get(r);if(o&&s.from-o.from<t)o.marks.push(s),o.until=Math.max(o.until,s.until);else{let a={lane:s.lane,kind:s.kind,from:s.from,until:s.until,marks:[s]};n.set(r,a),e.push(a)}}return e}var Tu=76,Pr=19,zo=18,Xx=5,UC=24,$x=1e6,Yx=60*$x,pp=[30*$x,...[1,2,5,10,20,60,120].map(i=>i*Yx)],FC=(i,t)=>t<Yx?We(i):We(i).slice(0,5);function qx({lane:i,marks:t,from:e}){let n=t.length>1?` and ${t.length-1} more`:"";return`${i}, ${We(e)}: ${Xt(t[0].label,160)}${n}`}var OC={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,-1],ArrowDown:[0,1]},Eu=class{#t;#e=Sn("g",{});#n=Sn("g",{});#i=new Map;#s="";panel;constructor(t){this.#t=t;let e=zo+Ds.length*Pr;this.panel=Sn("svg",{id:"work",height:e,width:"100%",role:"group","aria-label":"What happened, over time"},this.#e,this.#n),this.panel.addEventListener("keydown",n=>this.#u(n))}draw(t,e,n){let s=Math.max(this.panel.clientWidth-Tu-4,100),r=c=>Tu+s*(Math.min(Math.max(c,e),n)-e)/(n-e),o=t.filter(c=>c.until>=e&&c.from<=n),a=Wx(o,Xx*(n-e)/s);this.#r(r,s,e,n);let l=new Map(a.map(c=>[`${c.lane} ${c.kind} ${c.from}`,c]));for(let[c,{made:h}]of this.#i)l.has(c)||(h.remove(),this.#i.delete(c));for(let[c,h]of l)this.#o(c,h,r);this.#c()}#r(t,e,n,s){let r=pp.find(l=>(s-n)/l<=8)??pp[pp.length-1],o=[];for(let l=Math.ceil(n/r)*r;l<=s;l+=r)o.push(l);let a=zo+Ds.length*Pr;this.#e.replaceChildren(...Ds.map((l,c)=>Sn("text",{x:0,y:zo+c*Pr+13,class:"lane"},l)),...Ds.map((l,c)=>Sn("rect",{x:Tu,y:zo+c*Pr+1,width:e,height:Pr-2,class:"lane"})),...o.map(l=>Sn("line",{x1:t(l),x2:t(l),y1:zo,y2:a,class:"tick"})),...o.filter(l=>t(l)<Tu+e-UC).map(l=>Sn("text",{x:t(l),y:12,class:"tick"},FC(l,r))))}#o(t,e,n){let s=this.#i.get(t)??this.#a(t,e);s.group=e,s.title.textContent=qx(e);let{made:r}=s,o=n(e.from);r.setAttribute("x",String(o)),r.setAttribute("y",String(zo+Ds.indexOf(e.lane)*Pr+3)),r.setAttribute("width",String(Math.max(n(e.until)-o,Xx))),r.setAttribute("aria-label",qx(e))}#a(t,e){let n=Sn("title",{}),s=Sn("rect",{height:Pr-6,rx:2,role:"button",tabindex:-1,class:`mark ${e.kind}`,"data-lane":e.lane},n);s.addEventListener("click",()=>this.#l(t)),s.addEventListener("focus",()=>{this.#s=t,this.#c()}),this.#n.append(s);let r={made:s,title:n,group:e};return this.#i.set(t,r),r}#l(t){let e=this.#i.get(t);e&&this.#t(e.group.marks)}#c(){this.#i.has(this.#s)||(this.#s=this.#h().at(-1)?.[0]??"");for(let[t,{made:e}]of this.#i)e.setAttribute("tabindex",t===this.#s?"0":"-1")}#h(){return[...this.#i].sort(([,t],[,e])=>t.group.from-e.group.from)}#u(t){let e=this.#i.get(this.#s);if(!e)return;if(t.key==="Enter"||t.key===" ")return t.preventDefault(),this.#l(this.#s);let n=OC[t.key],s=n&&(n[0]?this.#f(e,n[0]):this.#d(e,n[1]));s&&(t.preventDefault(),s.made.focus())}#f(t,e){let n=this.#h().filter(([,{group:s}])=>s.lane===t.group.lane);return n[n.findIndex(([,s])=>s===t)+e]?.[1]}#d(t,e){let n=({group:s})=>Math.abs(s.from-t.group.from);for(let s=Ds.indexOf(t.group.lane)+e;s>=0&&s<Ds.length;s+=e){let r=[...this.#i.values()].filter(({group:o})=>o.lane===Ds[s]);if(r.length)return r.sort((o,a)=>n(o)-n(a))[0]}}};var BC=[["2 minutes",12e7],["10 minutes",6e8],["1 hour",36e8],["8 hours",8*36e8]],kC=5e3;function Zx(i,t,e){let n=new bu(e),s=new Eu(u=>n.open(u)),r=E("select",{"aria-label":"How much of the past"},...BC.map(([u,f])=>E("option",{value:f,selected:u==="10 minutes"},u))),o={goals:[],states:[],refusals:[]},a=si(()=>{if(s.panel.clientWidth===0)return;let u=i.moment??Date.now()*1e3,f=u-Number(r.value);t.reach(f);let d=[...zx(o.goals,o.states,u),...kx(t.until(u)),...Hx(l.servo(u)),...Gx(l.sightings(u)),...Vx(o.refusals)];s.draw(d,f,u)}),l=new wu(i,a),c=(u,f)=>i.follow(u,d=>{o[f]=d,a()});return c("(goal ?n ?facts)","goals"),c("(goal-state ?n ?state ?detail)","states"),c("(board-refusal ?client ?symbol ?count ?sentence)","refusals"),r.addEventListener("change",a),new ResizeObserver(a).observe(s.panel),setInterval(a,kC),{panel:E("section",{"aria-label":"Over time"},E("div",{class:"row"},E("h2",{},"Over time"),E("label",{},"The last ",r)),s.panel,n.panel),draw:a}}var Jx="(event ?n ?kind ?sentence ?detail)",mp=5e3,or=i=>i.facts[0].when,rl=i=>`${ut(i)[1]}@${or(i)}`,Au=class{#t;#e=new Map;#n=!1;#i=!1;#s=[];constructor(t){this.#t=t,t.follow(Jx,e=>{this.#o(e),this.#r()})}onChange(t){this.#s.push(t)}#r(){for(let t of this.#s)t()}until(t){return[...this.#e.values()].filter(n=>or(n)<=t).sort((n,s)=>or(n)-or(s)||ut(n)[1]-ut(s)[1])}async reach(t){if(!(this.#n||this.#i)){for(this.#n=!0;!this.#i&&this.#e.size<mp;){let e=this.until(1/0)[0];if(!e||ut(e)[1]<=1||or(e)<=t)break;let n=this.#e.size;this.#o(await this.#t.askThen(Jx,or(e)).catch(()=>[])),this.#i=this.#e.size===n,this.#r()}this.#n=!1}}#o(t){for(let n of t)this.#e.set(rl(n),n);if(this.#e.size<=mp)return;let e=[...this.#e].sort(([,n],[,s])=>or(n)-or(s)).slice(0,this.#e.size-mp);for(let[n]of e)this.#e.delete(n)}};var zC=200;function VC(i,t,e){let n=i.map(ut).filter(a=>a[1]<t),s=n.filter(a=>xs(a[4])?.goal===e).toSorted((a,l)=>l[1]-a[1])[0],r=s&&xs(s[4]);if(!r)return null;let o=n.filter(a=>a[1]>s[1]&&$(a[2])==="operation").map(a=>te(a[4]));return{operations:r.operations,begun:new Set(o)}}function GC(i,t,e){let n=xs(e),s=n&&VC(i,t,n.goal);return s?Gm(s.operations,n.operations,s.begun):E("pre",{},Xt(te(e),4e3))}function HC({connection:i,images:t},e,n,s){let[,r,o,a,l]=ut(s),c=s.facts[0],h=E("summary",{},E("time",{},We(c.when)),E("span",{class:`kind ${$(o)}`},$(o)),E("span",{},Xt($(a)))),u=E("div",{}),f=E("div",{});return E("details",{"data-number":r,ontoggle:async({target:g})=>{g.open&&(u.replaceChildren(Bx(i,t.telling(),c.when)),f.replaceChildren(await Fx(i,n,s)))}},h,E("p",{class:"quiet"},Xr(s.ids[0],c)),E("button",{type:"button",class:"small",onclick:()=>e(c.when)},"Show all as it was then"),u,f,Mm(i,s.ids[0],c),GC(n,r,l))}function Kx(i,t){let{connection:e,permission:n,entries:s}=i,r=E("div",{class:"timeline"}),o=E("pre",{class:"answer",hidden:!0}),a=async()=>{o.hidden=!1;try{o.textContent=(await e.request("coordinator","(why)")).map(p=>Xt(p,1e3)).join(`
`)}catch(p){o.textContent=Te(p)}},l=()=>s.until(e.moment??1/0),c=p=>HC(i,t,l(),p),h=Zx(e,s,c),u=E("button",{type:"button",id:"why",onclick:a},"Why this, now?"),f=new Mn("why-not-asked");n.onChange(()=>f.set("Why this",[u],n.line||n.right("request"))),_t("story").append(E("div",{class:"row"},u,f.note),o,h.panel,Ox(e),r);let d=new Map,g=p=>{let m=d.get(rl(p))??c(p);return d.set(rl(p),m),m},y=si(()=>{let p=l().reverse().slice(0,zC),m=new Set(p.map(rl));for(let v of d.keys())m.has(v)||d.delete(v);fl(r,p.map(g)),h.draw()});s.onChange(y)}var WC={ArrowRight:1,ArrowLeft:-1};function jx(){let i=[...document.querySelectorAll("[role=tab]")].filter(e=>e instanceof HTMLElement),t=e=>{for(let n of i)n.setAttribute("aria-selected",String(n===e)),n.tabIndex=n===e?0:-1,_t(n.getAttribute("aria-controls")??"").hidden=n!==e};for(let e of i)e.addEventListener("click",()=>t(e)),e.addEventListener("keydown",n=>{let s=WC[n.key];if(!s)return;let r=i.filter(a=>!a.hidden),o=r[(r.indexOf(e)+s+r.length)%r.length];t(o),o.focus()});t(i[0])}var Cu=class{#t;#e;#n;chosen=-1;constructor(t,e){this.#t=t,this.#e=e;let n=`${t.id}-words`;this.#n=E("ul",{id:n,class:"words",role:"listbox","aria-label":"What may come next",hidden:!0}),t.after(this.#n);let s={role:"combobox","aria-autocomplete":"list","aria-expanded":"false","aria-controls":n};for(let[r,o]of Object.entries(s))t.setAttribute(r,o)}get isOpen(){return!this.#n.hidden}offer(t){if(this.#n.replaceChildren(...t.map((e,n)=>this.#i(e,n))),t.length===0)return this.close();this.#n.hidden=!1,this.#t.setAttribute("aria-expanded","true"),this.choose(-1)}choose(t){this.chosen=t;let e=[...this.#n.children];if(e.forEach((n,s)=>n.setAttribute("aria-selected",String(s===t))),t<0)return this.#t.removeAttribute("aria-activedescendant");this.#t.setAttribute("aria-activedescendant",e[t].id),e[t].scrollIntoView({block:"nearest"})}move(t){let e=this.#n.children.length,n=this.chosen<0&&t<0?0:this.chosen;this.choose((n+t+e)%e)}close(){this.#n.hidden=!0,this.choose(-1),this.#t.setAttribute("aria-expanded","false")}#i(t,e){let n=E("li",{role:"option",id:`${this.#n.id}-${e}`,"aria-selected":"false"},t);return n.addEventListener("pointerdown",s=>{s.preventDefault(),this.#e(e)}),n}};var XC=12;function Qx(i,t){let e={from:0,words:[]},n=()=>i.selectionStart??0,s=l=>{i.setRangeText(e.words[l].put,e.from,n(),"end"),i.dispatchEvent(new Event("input",{bubbles:!0}))},r=new Cu(i,s),o=()=>{e=t(i.value.slice(0,n())),r.offer(e.words.slice(0,XC).map(({word:l})=>l))},a=({key:l,shiftKey:c})=>l==="Enter"?r.chosen>=0:l==="Tab"&&!c&&(r.chosen>=0||n()>e.from);i.addEventListener("input",o),i.addEventListener("blur",()=>r.close()),i.addEventListener("keydown",l=>{r.isOpen?l.key==="ArrowDown"||l.key==="ArrowUp"?(l.preventDefault(),r.move(l.key==="ArrowDown"?1:-1)):a(l)?(l.preventDefault(),s(Math.max(r.chosen,0))):(l.key==="Enter"||l.key==="Escape")&&r.close():l.key==="ArrowDown"&&o()})}var qC="end-effector";function $C(i){let t=new Map;for(let[,,e]of i.map(ut)){let n=r=>e.filter(o=>$(o[0])===r).flatMap(o=>o.slice(1));if(!n("offers").some(r=>$(r[0])==="goal"))continue;let s=new Set(n("reads").map($));for(let[,r,o,...a]of n("posts"))s.has($(r))&&o.every(([,c])=>$(c)==="symbol")&&!a.some(c=>$(c[0])==="durable")&&t.set($(r),o.length)}return t}var Ru=class{#t=[];#e=[];#n=new Map;constructor(t,e){t.follow("(contract ?name ?form)",n=>this.#n=$C(n)),t.follow("(believed ?fact)",n=>{this.#e=n.flatMap(s=>ut(s)[1].slice(1).map($))}),t.follow("(learned ?eyes ?name 1 ? ? ? ? ? ?)",n=>{let s=n.map(r=>$(ut(r)[2])).filter(r=>r!==qC&&Dl(r));this.#t=[...new Set(s)],e(this.#t)})}words(){return{predicates:this.#n,names:[...new Set([...this.#t,...this.#e])].sort()}}};var ty=["and","or","not","then","keep"];function YC(i){let t=[];for(let[r]of i.matchAll(/[()]|[^\s()]+/g))r==="("?t.push([]):r===")"?(t.pop(),t.at(-1)?.push("()")):t.at(-1)?.push(r);let e=t.at(-1);if(!e)return null;let[n="",...s]=e;return{head:n,rest:s}}function ey(i,{predicates:t,names:e}){let n=i.match(/[^\s()]*$/)?.[0]??"",s=i.slice(0,i.length-n.length),r=YC(s),o=[...t.keys(),...ty],a=(f,d)=>f.filter(g=>g!==n&&g.startsWith(n.toLowerCase())).map(g=>({word:g,put:d(g)})),l=f=>({from:s.length,words:f});if(!r&&n===""&&s.trim()!=="")return l([]);if(!r||ty.includes(r.head))return l(a(o,f=>`(${f} `));if(r.head==="")return l(a(o,f=>`${f}${t.get(f)===0?")":" "}`));let c=t.get(r.head.toLowerCase());if(c===void 0)return l(a(e,f=>`${f} `));let h=c-r.rest.length;if(h<=0)return l([]);let u=e.filter(f=>!r.rest.includes(f));return l(a(u,f=>`${f}${h===1?")":" "}`))}var ny="the table",ZC=16,gp=class{#t=[];#e=new Map;#n="";#i="";#s=E("div",{class:"towers",role:"group","aria-label":"Towers"});panel=E("div",{id:"sketch",hidden:!0});constructor(t){this.written=t;let e=E("button",{type:"button",onclick:()=>this.#c()},"Clear");this.panel.append(this.#s,E("div",{class:"row"},E("span",{class:"quiet"},"Drag a block onto another."),e)),this.#s.addEventListener("pointerup",n=>this.#h(n)),this.#s.addEventListener("pointercancel",()=>this.#i="")}setNames(t){this.#t=t.slice(0,ZC);for(let[e,n]of this.#e)(!this.#t.includes(e)||!this.#t.includes(n))&&this.#e.delete(e);this.#d()}#r(t){return[...this.#e].find(([,e])=>e===t)?.[0]}#o(t){let e=this.#r(t);return e?[t,...this.#o(e)]:[t]}#a(t,e){if(this.#n="",e===ny)this.#e.delete(t);else if(t!==e&&!this.#o(t).includes(e)){let n=this.#l(e);this.#e.delete(t),this.#e.set(t,this.#o(n).at(-1)??n)}this.#d(),this.written(this.#t.flatMap(n=>this.#e.has(n)?[`(on ${n} ${this.#e.get(n)})`]:[]).join(" "))}#l(t){let e=this.#e.get(t);return e===void 0?t:this.#l(e)}#c(){this.#e.clear(),this.#n="",this.#d(),this.written("")}#h(t){let e=this.#i;if(this.#i="",!e)return;let n=document.elementFromPoint(t.clientX,t.clientY)?.closest("[data-block], .towers"),s=n&&(n.getAttribute("data-block")??ny);s&&s!==e&&this.#a(e,s)}#u(t){if(this.#n&&this.#n!==t)return this.#a(this.#n,t);this.#n=this.#n?"":t,this.#d()}#f(t){let e=E("button",{type:"button",class:"block","data-block":t,"aria-pressed":String(t===this.#n)},Xt(t,20));return e.addEventListener("pointerdown",n=>{this.#i=t,e.releasePointerCapture?.(n.pointerId)}),e.addEventListener("click",()=>this.#u(t)),e}#d(){let t=this.#t.filter(e=>!this.#e.has(e));this.#s.replaceChildren(...t.map(e=>E("div",{class:"tower"},...this.#o(e).toReversed().map(n=>this.#f(n)))))}};function iy(){let i=new gp(n=>_t("goal-text").value=n),t=E("button",{type:"button",id:"sketch-toggle","aria-expanded":"false","aria-controls":"sketch"},"Sketch"),e=n=>{i.panel.hidden=!n,t.setAttribute("aria-expanded",String(n))};return t.addEventListener("click",()=>e(!!i.panel.hidden)),_t("goal-form").addEventListener("submit",()=>e(!1)),_t("cancel").before(t),_t("goal-answer").before(i.panel),i}var JC=12;function KC(i,t){let e=Number(t.place?.match(/^goal:1:(\d+)/)?.[1]??0);if(i.setAttribute("aria-invalid","true"),e===0)return;let n=i.value.slice(e-1).match(/^[()]|^[^\s()]+/)?.[0]??" ";i.focus(),i.setSelectionRange(e-1,e-1+n.length)}function Vo(i,t=""){let e=_t("goal-answer");e.hidden=!1,e.className=t,e.textContent=i}async function jC(i,t){Vo("asking \u2026"),t.removeAttribute("aria-invalid");try{let[e]=await i.goal(t.value,n=>{"error"in n?Vo(Te(n.error),"bad"):Vo(`goal ${e} ${n.values[0]}`,n.values[0]==="reached"?"good":"")});Vo(`goal ${e} accepted`)}catch(e){Vo(Te(e),"bad"),KC(t,e)}}async function QC(i){try{await i.request("coordinator","(cancel)")}catch(t){Vo(Te(t),"bad")}}function tR(i,t){i.follow("(goal-state ?n ?state ?detail)",e=>{let n=e.map(ut).toSorted((o,a)=>a[1]-o[1])[0],s=n?$(n[2]):"",r=_t("goal-chip");r.hidden=!n,document.body.dataset.goal=s,t(s),n&&(r.textContent=`goal ${n[1]}: ${s}`,r.className=`chip ${s==="reached"?"good":s==="running"?"busy":"warn"}`)})}function sy(i,t){let e=iy(),n=_t("goal-text");_t("goal-form").addEventListener("submit",l=>{l.preventDefault(),jC(i,n)}),n.addEventListener("input",()=>n.removeAttribute("aria-invalid")),_t("cancel").addEventListener("click",()=>QC(i));let s=new Mn("why-want");_t("goal-form").append(s.note);let r=!1,o=()=>{s.set("Go",[_t("go")],t.command("goal")),s.set("Cancel",[_t("cancel")],t.command("request")||(r?"":"no goal is running"))};t.onChange(o),tR(i,l=>{r=l==="running",o()});let a=new Ru(i,l=>e.setNames(l.slice(0,JC)));Qx(n,l=>ey(l,a.words()))}var ln=new wl,Ns=new Wl,Xi=new El(ln,Ns),ol=new Pl(ln),_p=new pl;jx();Wp();var eR=Im(ln),nR=Bm(Ns);Dx(ln,Ns,Xi);Am(Xi);var oy=i_(ln,ol,_p),xp=Om(ln,ol),ay=new Au(ln);sy(ln,Ns);Wm(ln,ay);Lx(ln);var ry={connection:ln,permission:Ns,entries:ay,images:xp};Kx(ry,Vm(ry));Pm(ln,Ns,xp,()=>Xi.me);ym({connection:ln,permission:Ns,images:xp,roles:ol},()=>Xi.me);fm({connection:ln,permission:Ns,hands:Xi,axes:_p});var ly=new ul(ln);Em(ln,ly,()=>Xi.me);tm(ln,ly,()=>Xi.me);im(ln);ln.onArm=oy.moveArm;ln.onHello=i=>{_t("cell").textContent=i.cell,Xi.me=i.name,Ns.set({mayNot:i.mayNot}),_p.set(i.axes),oy.setCell(i)};ol.onChange(()=>{Xi.robot=ol.server("robot")||Xi.robot,Xi.changed()});ln.onState=(i,t)=>{nR(i,t),eR(i,t)};ln.open();
/*! uPlot
The MIT License (MIT)

Copyright (c) 2022 Leon Sorokin

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in
all copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN
THE SOFTWARE.
*/
